"""Objects of LLVM made modules: what is taken, and what is refused."""

from __future__ import annotations

import subprocess

import llvmlite.binding as llvm
import pytest

from flowlanes.flow.kernel.wasm import wasm_module
from flowlanes.flow.machine_code.wasm_object import (
    MAGIC,
    NotSelfContainedError,
    leb,
    module_of_object,
    sections,
)
from needs import needs

SQUARE = "define double @square(double %x) { %y = fmul double %x, %x ret double %y }"
FOURTH = """
define internal double @own(double %x) noinline { %y = fmul double %x, %x ret double %y }
define double @fourth(double %x) {
  %y = call double @own(double %x)
  %z = call double @own(double %y)
  ret double %z
}
"""


def object_of(text):
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    machine = llvm.Target.from_triple("wasm32-unknown-unknown").create_target_machine()
    return machine.emit_object(llvm.parse_assembly(text))


def test_a_module_has_the_sections_that_it_needs_in_order():
    kinds = [kind for kind, _ in sections(wasm_module([SQUARE], ["square"]))]
    assert kinds == sorted(kinds, key=lambda kind: kind) and set(kinds) == {1, 2, 3, 7, 10}


@pytest.mark.parametrize("number", [0, 1, 127, 128, 624485, 2**31])
def test_numbers_in_bytes_of_seven_bits(number):
    value = sum((byte & 0x7F) << 7 * i for i, byte in enumerate(leb(number)))
    assert value == number and all(byte >= 0x80 for byte in leb(number)[:-1])


@needs("node")
def test_exported_functions_compute():
    module = wasm_module([SQUARE, FOURTH], ["fourth", "square"])
    program = """
    const memory = new WebAssembly.Memory({ initial: 1 });
    const bytes = Buffer.from(process.argv[1], "hex");
    const { instance, module } = await WebAssembly.instantiate(bytes, { env: { memory } });
    const { square, fourth } = instance.exports;
    console.log(square(3), fourth(3), WebAssembly.Module.imports(module).length);
    """
    done = subprocess.run(
        ["node", "--input-type=module", "-e", program, module.hex()],
        capture_output=True,
        check=False,
        text=True,
    )
    assert done.stdout.split() == ["9", "81", "1"], done.stderr


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (
            "declare double @sin(double)\n"
            "define double @f(double %x) { %y = call double @sin(double %x) ret double %y }",
            "the object needs sin",
        ),
        (
            "@table = constant [2 x double] [double 1.0, double 2.0]\n"
            "define ptr @f() { ret ptr @table }",
            "section of kind|symbol of kind",
        ),
        (
            "define double @f(i64 %i) { %p = alloca double, i64 %i\n store volatile double 1.0, "
            "ptr %p\n %x = load volatile double, ptr %p\n ret double %x }",
            "__stack_pointer",
        ),
    ],
)
def test_what_needs_a_linker_is_refused(text, reason):
    """A function from elsewhere, data, and the stack."""
    with pytest.raises(NotSelfContainedError, match=reason):
        module_of_object(object_of(text), ["f"])


def test_a_function_that_is_not_there_is_refused():
    with pytest.raises(NotSelfContainedError, match="no function cube"):
        wasm_module([SQUARE], ["square", "cube"])


def test_other_bytes_are_refused():
    with pytest.raises(NotSelfContainedError, match="no WebAssembly"):
        module_of_object(b"\x7fELF" + MAGIC, [])
