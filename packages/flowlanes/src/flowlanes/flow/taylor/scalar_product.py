"""Scalar products of short vectors, summed in an order independent of the processor."""

from __future__ import annotations

#: Number of doubles in a vector.
WIDTH = 8
_VECTOR, _ONE = f"<{WIDTH} x double>", "<1 x double>"
_HALF, _QUARTER = f"<{WIDTH // 2} x double>", f"<{WIDTH // 4} x double>"

# Only one copy, so that the code of large systems stays small; halves are added in a fixed order.
_TEXT = f"""
define internal {_ONE} @scalar_product(ptr %a, ptr %b) #1 {{
entry:
BODY
  %h0 = shufflevector {_VECTOR} %total, {_VECTOR} poison, <4 x i32> <i32 0, i32 1, i32 2, i32 3>
  %h1 = shufflevector {_VECTOR} %total, {_VECTOR} poison, <4 x i32> <i32 4, i32 5, i32 6, i32 7>
  %h = fadd {_HALF} %h0, %h1
  %q0 = shufflevector {_HALF} %h, {_HALF} poison, <2 x i32> <i32 0, i32 1>
  %q1 = shufflevector {_HALF} %h, {_HALF} poison, <2 x i32> <i32 2, i32 3>
  %q = fadd {_QUARTER} %q0, %q1
  %o0 = shufflevector {_QUARTER} %q, {_QUARTER} poison, <1 x i32> <i32 0>
  %o1 = shufflevector {_QUARTER} %q, {_QUARTER} poison, <1 x i32> <i32 1>
  %o = fadd {_ONE} %o0, %o1
  ret {_ONE} %o
}}
"""


def emit_scalar_product(groups: int) -> str:
    """Function of two addresses: the scalar product of the vectors stored there, as code.

    Parameters
    ----------
    groups : int
        Number of vectors of eight in each factor.
    """
    lines: list[str] = []
    total = ""
    for g in range(groups):
        shift = g * WIDTH
        lines += [
            f"  %pa{g} = getelementptr double, ptr %a, i64 {shift}",
            f"  %pb{g} = getelementptr double, ptr %b, i64 {shift}",
            f"  %a{g} = load {_VECTOR}, ptr %pa{g}, align 8",
            f"  %b{g} = load {_VECTOR}, ptr %pb{g}, align 8",
        ]
        lines.append(
            f"  %s{g} = fmul {_VECTOR} %a{g}, %b{g}"
            if g == 0
            else f"  %s{g} = call {_VECTOR} @llvm.fma.v{WIDTH}f64({_VECTOR} %a{g}, "
            f"{_VECTOR} %b{g}, {_VECTOR} {total})"
        )
        total = f"%s{g}"
    lines.append(f"  %total = fadd {_VECTOR} {total}, zeroinitializer")
    return _TEXT.replace("BODY", "\n".join(lines))
