# SPDX-License-Identifier: Apache-2.0
"""C text to functions and global variables (README.md: the language). Everything else is an error."""
from __future__ import annotations

import subprocess
from dataclasses import dataclass, field
from pathlib import Path

from pycparser import c_ast, c_parser

INTRINSICS = {"io_read": 1, "io_write": 2}
ENTRIES = ("firmware_reset", "firmware_poll")


class FirmwareError(Exception):
    """What is wrong, as file:line:col: error: what."""


def fail(node: c_ast.Node | None, what: str) -> None:
    raise FirmwareError(f"{node.coord if node is not None else 'firmware'}: error: {what}")


@dataclass
class Function:
    name: str
    parameters: list[str]
    gives: bool                      # a u16, else nothing
    body: c_ast.Compound
    node: c_ast.FuncDef
    locals: dict[str, int] = field(default_factory=dict)   # variable -> words
    calls: set[str] = field(default_factory=set)


@dataclass
class Unit:
    globals: dict[str, int]          # variable -> words; an array has more than one, or is in arrays
    arrays: set[str]
    constants: dict[str, int]        # of enums
    functions: dict[str, Function]


def preprocess(source: Path, include: list[Path], defines: list[str]) -> str:
    """The text that the parser gets, line markers kept."""
    command = ["gcc", "-E", "-nostdinc", "-x", "c", *(f"-I{path}" for path in include),
               *(f"-D{define}" for define in defines), str(source)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode:
        raise FirmwareError(run.stderr.strip().replace(": fatal error: ", ": error: "))
    return run.stdout


def is_u16(node: c_ast.Node) -> bool:
    return (isinstance(node, c_ast.TypeDecl) and isinstance(node.type, c_ast.IdentifierType)
            and node.type.names in (["u16"], ["unsigned", "short"]))


def is_void(node: c_ast.Node) -> bool:
    return (isinstance(node, c_ast.TypeDecl) and isinstance(node.type, c_ast.IdentifierType)
            and node.type.names == ["void"])


def constant(node: c_ast.Node, constants: dict[str, int]) -> int | None:
    """The value of a constant expression, modulo 2^16; None if it is none."""
    if isinstance(node, c_ast.Constant):
        if node.type == "char":
            return ord(node.value[1:-1].encode().decode("unicode_escape"))
        if node.type not in ("int", "unsigned int"):
            fail(node, f"{node.value}: only whole numbers and characters are constants here")
        return int(node.value.rstrip("uU"), 0) & 0xFFFF
    if isinstance(node, c_ast.ID):
        return constants.get(node.name)
    if isinstance(node, c_ast.UnaryOp) and node.op in ("-", "~", "!", "+"):
        value = constant(node.expr, constants)
        if value is None:
            return None
        return {"-": -value, "~": ~value, "!": int(not value), "+": value}[node.op] & 0xFFFF
    if isinstance(node, c_ast.BinaryOp):
        left, right = constant(node.left, constants), constant(node.right, constants)
        if left is None or right is None:
            return None
        return fold(node, left, right)
    return None


def fold(node: c_ast.BinaryOp, left: int, right: int) -> int:
    if node.op in ("/", "%") and right == 0:
        fail(node, "division by zero")
    operations = {
        "+": lambda: left + right, "-": lambda: left - right, "*": lambda: left * right,
        "/": lambda: left // right, "%": lambda: left % right, "&": lambda: left & right,
        "|": lambda: left | right, "^": lambda: left ^ right, "<<": lambda: left << min(right, 16),
        ">>": lambda: left >> right, "==": lambda: int(left == right), "!=": lambda: int(left != right),
        "<": lambda: int(left < right), "<=": lambda: int(left <= right), ">": lambda: int(left > right),
        ">=": lambda: int(left >= right), "&&": lambda: int(bool(left and right)),
        "||": lambda: int(bool(left or right))}
    return operations[node.op]() & 0xFFFF


class Locals(c_ast.NodeVisitor):
    """Collects a function's variables and calls."""

    def __init__(self, function: Function, unit: Unit, defined: set[str]) -> None:
        self.function, self.unit, self.defined = function, unit, defined

    def visit_Decl(self, node: c_ast.Decl) -> None:  # noqa: N802
        if not is_u16(node.type):
            fail(node, f"local {node.name}: only u16; arrays stand outside of functions")
        if node.name in self.function.locals:
            fail(node, f"{node.name} stands twice in {self.function.name}: give it another name")
        if node.name in self.unit.globals:
            fail(node, f"{node.name} hides a global variable: give it another name")
        self.function.locals[node.name] = 1
        if node.init is not None:
            self.visit(node.init)

    def visit_FuncCall(self, node: c_ast.FuncCall) -> None:  # noqa: N802
        if not isinstance(node.name, c_ast.ID):
            fail(node, "a call of what is no function's name")
        if node.name.name not in INTRINSICS and node.name.name not in self.defined:
            fail(node, f"{self.function.name} calls {node.name.name}, which is not there")
        self.function.calls.add(node.name.name)
        self.generic_visit(node)


def declare(unit: Unit, node: c_ast.Decl) -> None:
    """A global variable; prototypes of intrinsics and functions are passed over."""
    if isinstance(node.type, c_ast.FuncDecl):
        return
    if isinstance(node.type, c_ast.Enum):
        enumerate_constants(unit, node.type)
        return
    if node.init is not None:
        fail(node, f"{node.name}: globals are 0 at reset and have no initialiser")
    if node.name in unit.globals:
        fail(node, f"{node.name} stands twice")
    if is_u16(node.type):
        unit.globals[node.name] = 1
    elif isinstance(node.type, c_ast.ArrayDecl) and is_u16(node.type.type):
        size = constant(node.type.dim, unit.constants) if node.type.dim is not None else None
        if not size:
            fail(node, f"{node.name}: an array has a constant size")
        unit.globals[node.name] = size
        unit.arrays.add(node.name)
    else:
        fail(node, f"{node.name}: only u16 and arrays of it")


def enumerate_constants(unit: Unit, node: c_ast.Enum) -> None:
    value = 0
    for each in node.values.enumerators:
        if each.value is not None:
            given = constant(each.value, unit.constants)
            if given is None:
                fail(each, f"{each.name}: its value is no constant")
            value = given
        unit.constants[each.name] = value
        value += 1


def define(unit: Unit, node: c_ast.FuncDef, defined: set[str]) -> None:
    declaration = node.decl.type
    gives = is_u16(declaration.type)
    if not gives and not is_void(declaration.type):
        fail(node, f"{node.decl.name}: gives u16 or nothing")
    parameters = []
    for each in declaration.args.params if declaration.args else []:
        if isinstance(each, c_ast.Typename) and is_void(each.type):
            continue
        if not isinstance(each, c_ast.Decl) or not is_u16(each.type):
            fail(node, f"{node.decl.name}: parameters are u16")
        parameters.append(each.name)
    if node.decl.name in unit.functions:
        fail(node, f"{node.decl.name} stands twice")
    function = Function(node.decl.name, parameters, gives, node.body, node)
    for name in parameters:
        if name in unit.globals:
            fail(node, f"{name} hides a global variable: give it another name")
        function.locals[name] = 1
    Locals(function, unit, defined).visit(node.body)
    unit.functions[function.name] = function


def parse(text: str, name: str) -> Unit:
    """A preprocessed text as a unit; unreachable functions are left out, recursion is an error."""
    try:
        tree = c_parser.CParser().parse(text, name)
    except Exception as error:  # pycparser's own class moved between its releases
        place, _, what = str(error).partition(": ")
        raise FirmwareError(f"{place}: error: syntax, {what}") from error
    unit = Unit({}, set(), {}, {})
    defined = {node.decl.name for node in tree.ext if isinstance(node, c_ast.FuncDef)}
    for node in tree.ext:
        if isinstance(node, c_ast.FuncDef):
            define(unit, node, defined)
        elif isinstance(node, c_ast.Decl):
            declare(unit, node)
        elif not isinstance(node, c_ast.Typedef):
            fail(node, "neither a variable nor a function")
    for entry in ENTRIES:
        if entry not in unit.functions:
            raise FirmwareError(f"{name}:1:1: error: no function {entry}")
    reachable: dict[str, Function] = {}
    for entry in ENTRIES:
        reach(unit, entry, (), reachable)
    unit.functions = {n: f for n, f in unit.functions.items() if n in reachable}
    return unit


def reach(unit: Unit, name: str, path: tuple[str, ...], reachable: dict[str, Function]) -> None:
    if name in INTRINSICS:
        return
    if name in path:
        fail(unit.functions[name].node, f"recursion: {' -> '.join((*path, name))}")
    reachable[name] = unit.functions[name]
    for called in sorted(unit.functions[name].calls):
        reach(unit, called, (*path, name), reachable)
