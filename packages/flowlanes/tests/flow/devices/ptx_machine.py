"""PTX carried out without a graphics processor, one thread after the other.

Every function becomes a function of Python.  Registers hold Python's floats and integers; where an
instruction asks for the other kind, bits are reinterpreted as on the device.  Memory is a
dictionary of words of 64 bits, so that a word that was never written is noticed.
"""

from __future__ import annotations

import ctypes
import ctypes.util
import itertools
import math
import re
import struct
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

_LIBM = ctypes.CDLL(ctypes.util.find_library("m"))
_LIBM.fma.argtypes = [ctypes.c_double] * 3
_LIBM.fma.restype = ctypes.c_double
_MASK = (1 << 64) - 1


def as_float(value: Any) -> float:
    """The double with these bits."""
    if type(value) is float:
        return value
    number: float = struct.unpack("<d", struct.pack("<Q", value & _MASK))[0]
    return number


def as_integer(value: Any) -> int:
    """The bits of a register as a signed integer."""
    if type(value) is float:
        number: int = struct.unpack("<q", struct.pack("<d", value))[0]
        return number
    return ((value & _MASK) ^ (1 << 63)) - (1 << 63)


def quotient(a: float, b: float) -> float:
    """a/b as IEEE 754 has it."""
    with np.errstate(all="ignore"):
        return float(np.float64(a) / np.float64(b))


def root(a: float) -> float:
    """The root; of a negative number it is not a number."""
    return math.sqrt(a) if a >= 0 or a != a else math.nan


def smaller(a: float, b: float) -> float:
    """The smaller of two; the other one of what is not a number."""
    return b if a != a else a if b != b else min(a, b)


def larger(a: float, b: float) -> float:
    """The larger of two; the other one of what is not a number."""
    return b if a != a else a if b != b else max(a, b)


_BINARY = {"add": "+", "sub": "-", "mul": "*"}
_ORDERED = {"eq": "==", "ne": "!=", "lt": "<", "le": "<=", "gt": ">", "ge": ">="}
_BITS = {"and": "&", "or": "|", "xor": "^"}


def _operand(text: str, kind: str) -> str:
    """An operand as an expression for a float (``"f"``), an integer (``"i"``) or bits (``"b"``)."""
    if text.startswith("0d"):
        bits = int(text[2:], 16)
        return f"as_float({bits})" if kind == "f" else str(as_integer(bits))
    if text.startswith("%"):
        name = text[1:]
        return {"f": f"as_float({name})", "i": f"as_integer({name})"}.get(kind, name)
    return f"as_float({text})" if kind == "f" else text


def _address(text: str) -> str:
    base, sign, shift = text.strip("[]").partition("+")
    return f"{_operand(base, 'i')}{sign}{shift}"


def _expression(name: str, kind: str, a: Sequence[str]) -> str:
    """The value of an instruction with a result."""
    f, i, b = ([_operand(x, k) for x in a] for k in "fib")
    whole = name if kind in ("", "b64", "pred") else f"{name}.{kind}"
    head, *modes = name.split(".")
    if head in ("mov", "cvta"):
        return b[0]
    if head == "setp":
        relation = modes[0]
        if kind != "f64":
            return f"{i[0]} {_ORDERED[relation]} {i[1]}"
        unordered = f"({f[0]} != {f[0]} or {f[1]} != {f[1]})"
        if relation in ("num", "nan"):
            return f"not {unordered}" if relation == "num" else unordered
        if relation in _ORDERED:
            test = f"{f[0]} {_ORDERED[relation]} {f[1]}"
            # Python's != holds for what is not a number, setp.ne does not
            return f"({test}) and not {unordered}" if relation == "ne" else test
        return f"({f[0]} {_ORDERED[relation[:-1]]} {f[1]}) or {unordered}"
    if head == "selp":
        return f"({b[0]} if {b[2]} else {b[1]})"
    if whole == "not.pred" or (head == "not" and kind == "pred"):
        return f"not {b[0]}"
    if head in _BITS:
        return f"{b[0]} {_BITS[head]} {b[1]}" if kind == "pred" else f"{i[0]} {_BITS[head]} {i[1]}"
    if kind == "f64" and head == "cvt":
        return {"rzi.s64": f"int({f[0]})"}[".".join(modes)]
    if kind == "s64" and head == "cvt":
        return {"rn.f64": f"float({i[0]})"}[".".join(modes)]
    if kind == "f64":
        if head in ("add", "sub", "mul", "fma", "div", "rcp", "sqrt") and modes != ["rn"]:
            raise ValueError(f"{whole}: a rounding that is left open")
        if head in _BINARY:
            return f"{f[0]} {_BINARY[head]} {f[1]}"
        return {
            "fma": lambda: f"fma({', '.join(f)})",
            "div": lambda: f"quotient({f[0]}, {f[1]})",
            "rcp": lambda: f"quotient(1.0, {f[0]})",
            "sqrt": lambda: f"root({f[0]})",
            "neg": lambda: f"-{f[0]}",
            "abs": lambda: f"abs({f[0]})",
            "min": lambda: f"smaller({f[0]}, {f[1]})",
            "max": lambda: f"larger({f[0]}, {f[1]})",
            "copysign": lambda: f"math.copysign({f[1]}, {f[0]})",
        }[head]()
    return {
        "add": lambda: f"{i[0]} + {i[1]}",
        "sub": lambda: f"{i[0]} - {i[1]}",
        "mul": lambda: f"{i[0]} * {i[1]}",
        "mad": lambda: f"{i[0]} * {i[1]} + {i[2]}",
        "shl": lambda: f"as_integer({i[0]} << {i[1]})",
        "shr": lambda: f"({i[0]} & {_MASK}) >> {i[1]}",
        "neg": lambda: f"-{i[0]}",
    }[head]()


def _statement(line: str) -> str:
    """A line of PTX inside a block, without control."""
    opcode, _, rest = line.rstrip(";").partition(" ")
    arguments = [x.strip() for x in re.split(r",(?![^(]*\))", rest.strip()) if x.strip()]
    name, _, kind = opcode.rpartition(".")
    if opcode.startswith("ld.param"):
        return f"{arguments[0][1:]} = {arguments[1].strip('[]')}"
    if opcode.startswith("st.param"):
        return f"{arguments[0].strip('[]')} = {_operand(arguments[1], 'b')}"
    if opcode.startswith("ld."):
        return f"{arguments[0][1:]} = memory[{_address(arguments[1])}]"
    if opcode.startswith("st."):
        return f"memory[{_address(arguments[0])}] = {_operand(arguments[1], 'b')}"
    if opcode == "atom.global.add.u64":
        place = _address(arguments[1])
        added = _operand(arguments[2], "i")
        return f"{arguments[0][1:]} = memory[{place}]; memory[{place}] += {added}"
    if opcode == "call.uni":
        return f"{arguments[0]}{arguments[1]}"
    return f"{arguments[0][1:]} = {_expression(name, kind, arguments[1:])}"


def _function(name: str, parameters: Sequence[str], body: str) -> str:
    """A function as a function of Python: a loop over its blocks."""
    blocks: list[list[str]] = [[]]
    labels: dict[str, int] = {}
    for raw in body.splitlines():
        line = raw.strip()
        if not line or line.startswith((".", "//", "{", "}")):
            continue
        line = re.sub(r"\s+", " ", line.split("//")[0].strip())
        if line.endswith(":"):
            labels[line[:-1]] = len(blocks)
            blocks.append([])
        elif line.startswith("@"):
            blocks[-1].append(line)
            blocks.append([])
        else:
            blocks[-1].append(line)
    lines = [f"def {name}({', '.join(parameters)}):", "  block = 0"]
    lines += [f"  {depot} = reserve()" for depot in re.findall(r"\.local.*\s(\w+)\[\d+\]", body)]
    lines.append("  while True:")
    for number, block in enumerate(blocks):
        lines.append(f"    if block == {number}:")
        lines.append(f"      block = {number + 1}")
        for line in block:
            condition = re.fullmatch(r"@(!?)%(p\d+) bra (\S+);", line)
            jump = re.fullmatch(r"bra\.uni (\S+);", line)
            if condition:
                negated = "not " if condition[1] else ""
                lines.append(
                    f"      if {negated}{condition[2]}: block = {labels[condition[3]]}; continue"
                )
            elif jump:
                lines += [f"      block = {labels[jump[1]]}", "      continue"]
            elif line == "ret;":
                lines.append("      return")
            else:
                lines.append(f"      {_statement(line)}")
    return "\n".join(lines)


@dataclass
class PtxMachine:
    """A graphics processor that has a few threads, which run one after the other.

    Attributes
    ----------
    threads : int
        Threads of a kernel.
    launches : list of tuple
        Of every kernel that was run: its name, the number of motions, its arguments.
    """

    threads: int = 3
    launches: list[tuple[str, int]] = field(default_factory=list)

    def run(
        self,
        ptx: str,
        entry: str,
        inputs: Sequence[Any],
        outputs: Sequence[np.ndarray],
        most: int,
    ) -> None:
        """Run a kernel; see :class:`flowlanes.flow.devices.cuda.GraphicsProcessor`."""
        self.launches.append((entry, most))
        for array in outputs:
            array.fill(np.nan if array.dtype.kind == "f" else 0)
        self.carry_out(ptx, entry, [*inputs, *outputs], most)

    def carry_out(self, ptx: str, entry: str, arguments: Sequence[Any], most: int) -> None:
        """Run a kernel on arrays, which it may change, and numbers."""
        memory: dict[int, Any] = {}
        passed: list[Any] = []
        places = itertools.count(1 << 40, 1 << 32)
        for argument in arguments:
            if isinstance(argument, np.ndarray):
                base = next(places)
                values = argument.ravel().tolist()
                memory.update((base + 8 * k, value) for k, value in enumerate(values))
                passed.append(base)
            else:
                passed.append(argument)
        kernel = load(ptx, memory)[entry]
        for _ in range(min(self.threads, most)):
            kernel(*passed)
        for array, base in zip(arguments, passed, strict=True):
            if isinstance(array, np.ndarray):
                kind = as_float if array.dtype == np.float64 else as_integer
                flat = array.reshape(-1)
                for k in range(array.size):
                    flat[k] = kind(memory[base + 8 * k])


def load(ptx: str, memory: dict[int, Any]) -> dict[str, Callable[..., None]]:
    """The functions of a text, on a memory."""
    stack = itertools.count(1 << 20, 1 << 20)
    names: dict[str, Any] = {
        "as_float": as_float,
        "as_integer": as_integer,
        "fma": _LIBM.fma,
        "larger": larger,
        "math": math,
        "memory": memory,
        "quotient": quotient,
        "reserve": lambda: next(stack),
        "root": root,
        "smaller": smaller,
    }
    pattern = r"\.(?:func|entry)\s+(\w+)\s*\(([^)]*)\)[^{;]*\{(.*?)^\}"
    for name, parameters, body in re.findall(pattern, ptx, re.DOTALL | re.MULTILINE):
        exec(_function(name, re.findall(r"\w+_param_\d+", parameters), body), names)
    return names
