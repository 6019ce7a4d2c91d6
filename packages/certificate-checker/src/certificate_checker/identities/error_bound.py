r"""Size of the prime for which identity tests fail with a probability below 2^−100.

Two elements of the algebra A of :mod:`.residues` are compared by their values at one random point
modulo one random prime p.  Let their difference be a quotient with a numerator G ≠ 0 of degree d
and height h (the sum of the absolute values of its coefficients is at most 2^h).  Both are bounded
by :mod:`.bounds` along with the claim, and for polynomials of a certificate by the limits of its
format.

*Roots.*  Replacing r_k^n by u_k, from the last root to the first, writes G in the basis of A; if u
has the degree a and the height b, this multiplies the degree by at most 1 + a and adds d (b + 1) to
the height.  Some coefficient g of G ≠ 0 is a polynomial other than 0, of degree D and height H.

*Primes.*  g vanishes modulo p only if p divides each of its coefficients, of which one is not zero
and at most 2^H; at most H/(β − 1) primes of β bits do.  Of the primes p ≡ 1 mod n with β bits,
p − 1 = n c and c prime to n, where β ≥ 320 and n ≤ 60, there are more than 2^β/(16 n β): they are
classes modulo q = n · rad n ≤ 3600, and π(x; q, a) differs from Li(x)/φ(q) by less than
x/(160 log² x) (Bennett, Martin, O'Bryant and Rechnitzer, Illinois J. Math. 62, 2018, 427–532).

*Points.*  Modulo every other prime g has at most a share D/p of zeros (Schwartz, J. ACM 27, 1980,
701–717; Zippel 1979).  Where g does not vanish, G does not vanish for all choices of the roots.
Primes and points are drawn until all u_i are powers, at most 2^20 times, which multiplies the
probability of a bad one by at most 2^20.  Where A is known to be a field, one choice of k square
roots is tried; there the norm of G takes the place of g, with 2^k times its degree and height.

In the whole check fewer than 2^30 pairs are compared, each with one of at most 129^s multiples
where s symbols may be combined, so that

    P(error) < 2^50 · 129^s · (2 D/2^β + 16 n² H/2^β) < 2^−100

for the β chosen here.  Prime and points follow from SHAKE-256 of the certificate, as if they were
drawn after it was written: an author who tries 2^k certificates succeeds with probability 2^(k −
100).
"""

from __future__ import annotations

from ..claim.errors import CheckError
from ..claim.polynomials import Poly
from .bounds import Bound, Bounds

#: Negative binary logarithm of the error probability.
SECURITY = 100

#: Bits of the smallest prime.
SMALLEST = 320

#: Largest least common multiple of the degrees of roots.
LARGEST_ORDER = 60

#: Degree and height of products in a certificate, by the limits of its format: 2,000 generators,
#: exponents and powers up to 10^5, 10^6 factors, and coefficients of 40,000 digits.
FORMAT = Bound(2**80, 2**80)


def of_polynomial(poly: Poly) -> Bound:
    """Bound of a polynomial in variables, after clearing denominators."""
    if poly.is_zero():
        return Bound(0, 1)
    numbers = list(poly.to_dict().values())
    height = (
        sum(int(c.q).bit_length() for c in set(numbers) if c.q != 1) + len(numbers).bit_length()
    )
    height += max(int(abs(c.p)).bit_length() for c in numbers)
    return Bound(int(poly.total_degree()), height)


def prime_bits(bounds: Bounds, order: int, symbols: int) -> int:
    """Bits of a prime for which the error probability is small enough.

    Parameters
    ----------
    bounds : Bounds
        Bounds of all compared expressions of the claim, and of radicands.
    order : int
        Least common multiple of the degrees of the roots.
    symbols : int
        Number of symbols that may be combined in one argument.
    """
    if order > LARGEST_ORDER:
        raise CheckError("the degrees of roots are too large")
    degree = 2 * bounds.degree + FORMAT.degree
    height = 2 * bounds.height + FORMAT.height + 1
    # Reduction by the equations of the roots, from the last to the first (see above).
    for own in reversed(bounds.radicands):
        height += degree * (own.height + 1)
        degree *= 1 + own.degree
        # The norm over both choices of a square root doubles degree and height.
        degree, height = 2 * degree, 2 * height
    worst = 2 * degree + 16 * order**2 * height
    return max(SMALLEST, SECURITY + 50 + 8 * symbols + worst.bit_length() + 1)
