# SPDX-License-Identifier: Apache-2.0
"""Functions to instructions: one accumulator, variables in RAM, temporaries where an expression needs them.

The last argument of a call is in the accumulator, the others in the called function's variables; so is a
result. A function's first instruction stores that argument.
"""
from __future__ import annotations

from pycparser import c_ast

from micro.front import INTRINSICS, Function, Unit, constant, fail
from micro.isa import MOST, Instruction, Label

BINARY = {"+": "ADD", "-": "SUB", "&": "AND", "|": "OR", "^": "XOR", "==": "EQ", "<": "LTU"}
IMMEDIATE = {"ADD": "ADDI", "SUB": "SUBI", "AND": "ANDI", "OR": "ORI", "XOR": "XORI", "EQ": "EQI",
             "LTU": "LTUI"}
COMMUTATIVE = ("ADD", "AND", "OR", "XOR", "EQ")
COMPARES = ("==", "!=", "<", "<=", ">", ">=")


class Generator:
    """The code of one function."""

    def __init__(self, unit: Unit, function: Function) -> None:
        self.unit, self.function = unit, function
        self.out: list[Instruction | Label] = []
        self.labels = 0
        self.used = 0                      # temporaries in use
        self.loops: list[tuple[str, str]] = []   # where continue and break go

    # ---- names ---------------------------------------------------------------------------------
    def emit(self, name: str, operand: int | str | tuple[str, int] = 0) -> None:
        self.out.append(Instruction(name, operand))

    def label(self) -> str:
        self.labels += 1
        return f"{self.function.name}.{self.labels}"

    def place(self, name: str) -> None:
        self.out.append(Label(name))

    def variable(self, node: c_ast.ID) -> str:
        """A scalar's name in RAM."""
        if node.name in self.function.locals:
            return f"{self.function.name}:{node.name}"
        if node.name not in self.unit.globals:
            fail(node, f"{node.name} is not declared")
        if node.name in self.unit.arrays:
            fail(node, f"{node.name} is an array")
        return node.name

    def temporary(self) -> str:
        name = f"%{self.used}"
        self.used += 1
        self.function.locals[name] = 1
        return f"{self.function.name}:{name}"

    def const(self, node: c_ast.Node) -> int | None:
        return constant(node, self.unit.constants)

    # ---- expressions ---------------------------------------------------------------------------
    def number(self, value: int) -> None:
        self.emit("LOADI", value & MOST)
        if value > MOST:
            self.emit("ORH", value >> 11)

    def simple(self, node: c_ast.Node) -> tuple[str, int] | int | None:
        """What an instruction can name: a small number, a scalar, an array's word at a constant."""
        value = self.const(node)
        if value is not None:
            return value if value <= MOST else None
        if isinstance(node, c_ast.ID):
            return (self.variable(node), 0)
        if isinstance(node, c_ast.ArrayRef):
            index = self.const(node.subscript)
            if index is not None:
                return (self.array(node), index)
        return None

    def array(self, node: c_ast.ArrayRef) -> str:
        name = node.name.name if isinstance(node.name, c_ast.ID) else None
        if name not in self.unit.arrays:
            fail(node, "an index of what is no array")
        index = self.const(node.subscript)
        if index is not None and index >= self.unit.globals[name]:
            fail(node, f"{name} has {self.unit.globals[name]} words")
        return name

    def split_index(self, node: c_ast.Node) -> tuple[c_ast.Node, int]:
        """A variable part of an index and a constant one, which the instruction adds."""
        offset = 0
        while isinstance(node, c_ast.BinaryOp) and node.op in ("+", "-"):
            right = self.const(node.right)
            if right is not None:
                offset += right if node.op == "+" else -right
                node = node.left
                continue
            left = self.const(node.left)
            if left is None or node.op == "-":
                break
            offset, node = offset + left, node.right
        return node, offset

    def apply(self, operation: str, operand: tuple[str, int] | int) -> None:
        if isinstance(operand, int):
            self.emit(IMMEDIATE[operation], operand)
        else:
            self.emit(operation, operand)

    def load(self, operand: tuple[str, int] | int) -> None:
        if isinstance(operand, int):
            self.number(operand)
        else:
            self.emit("LOAD", operand)

    def operate(self, operation: str, left: c_ast.Node, right: c_ast.Node) -> None:
        """acc = left operation right."""
        if operation in ("ADD", "SUB", "OR", "XOR") and self.const(right) == 0:
            self.expression(left)
            return
        if operation in ("ADD", "OR", "XOR") and self.const(left) == 0:
            self.expression(right)
            return
        simple_left, simple_right = self.simple(left), self.simple(right)
        if simple_right is not None:
            self.expression(left)
            self.apply(operation, simple_right)
        elif simple_left is not None and operation in COMMUTATIVE:
            self.expression(right)
            self.apply(operation, simple_left)
        elif simple_left is not None and not has_call(right):
            mark = self.used
            self.expression(right)
            temporary = self.temporary()
            self.emit("STORE", (temporary, 0))
            self.load(simple_left)
            self.emit(operation, (temporary, 0))
            self.used = mark
        else:
            # C leaves the order open; from left to right where it costs nothing.
            mark = self.used
            first, then = (left, right) if operation in COMMUTATIVE else (right, left)
            self.expression(first)
            temporary = self.temporary()
            self.emit("STORE", (temporary, 0))
            self.expression(then)
            self.emit(operation, (temporary, 0))
            self.used = mark

    def expression(self, node: c_ast.Node) -> None:
        """acc = node."""
        value = self.const(node)
        if value is not None:
            self.number(value)
            return
        simple = self.simple(node)
        if simple is not None:
            self.load(simple)
            return
        if isinstance(node, c_ast.ArrayRef):
            name = self.array(node)
            index, offset = self.split_index(node.subscript)
            self.expression(index)
            self.emit("LOADX", (name, offset))
        elif isinstance(node, c_ast.FuncCall):
            self.call(node, True)
        elif isinstance(node, c_ast.UnaryOp):
            self.unary(node)
        elif isinstance(node, c_ast.BinaryOp):
            self.binary(node)
        elif isinstance(node, c_ast.TernaryOp):
            no, end = self.label(), self.label()
            self.branch(node.cond, no, False)
            self.expression(node.iftrue)
            self.emit("JUMP", end)
            self.place(no)
            self.expression(node.iffalse)
            self.place(end)
        elif isinstance(node, c_ast.Cast):
            self.expression(node.expr)
        else:
            fail(node, f"{type(node).__name__} is not in the language here")

    def unary(self, node: c_ast.UnaryOp) -> None:
        if node.op == "~":
            self.expression(node.expr)
            self.emit("NOT")
        elif node.op == "-":
            self.expression(node.expr)
            self.emit("NOT")
            self.emit("ADDI", 1)
        elif node.op == "!":
            self.expression(node.expr)
            self.emit("EQI", 0)
            self.emit("TEST")
        else:
            fail(node, f"operator {node.op} is not in the language here")

    def binary(self, node: c_ast.BinaryOp) -> None:
        operation = node.op
        if operation in ("&&", "||", *COMPARES):
            self.truth(node)
        elif operation in ("<<", ">>"):
            count = self.const(node.right)
            if count is None:
                fail(node, "shifts are by constants")
            if count > 15:
                fail(node, "a shift by more than 15 bits")
            self.expression(node.left)
            if count:
                self.emit("SHIFT", count + (16 if operation == ">>" else 0))
        elif operation == "*":
            self.multiply(node)
        elif operation in BINARY:
            right = self.const(node.right)
            if operation == "&" and right is not None and self.shift_out(node.left, right):
                return
            if operation == "-" and right is not None and right > MOST:
                self.operate("ADD", node.left, c_ast.Constant("int", str(-right & 0xFFFF), node.coord))
            else:
                self.operate(BINARY[operation], node.left, node.right)
        else:
            fail(node, f"operator {operation} is not in the language here")

    def shift_out(self, value: c_ast.Node, mask: int) -> bool:
        """acc = value & mask by two shifts, if the mask is one run of bits at an end and a long number."""
        low = mask & mask + 1 == 0
        if mask <= MOST or not (low or (mask | mask - 1) == 0xFFFF):
            return False
        count = 16 - mask.bit_count()
        self.expression(value)
        if count:
            self.emit("SHIFT", count if low else 16 + count)
            self.emit("SHIFT", 16 + count if low else count)
        return True

    def multiply(self, node: c_ast.BinaryOp) -> None:
        left, right = node.left, node.right
        if self.const(right) is None:
            left, right = right, left
        factor = self.const(right)
        if factor is None or factor & (factor - 1) or not factor:
            fail(node, "products are by powers of two")
        self.expression(left)
        if factor > 1:
            self.emit("SHIFT", factor.bit_length() - 1)

    def truth(self, node: c_ast.Node) -> None:
        """acc = 0 or 1."""
        if isinstance(node, c_ast.BinaryOp) and node.op in COMPARES:
            opposite = self.compare(node)
            self.emit("TEST")
            if opposite:
                self.emit("XORI", 1)
            return
        no, end = self.label(), self.label()
        self.branch(node, no, False)
        self.emit("LOADI", 1)
        self.emit("JUMP", end)
        self.place(no)
        self.emit("LOADI", 0)
        self.place(end)

    def compare(self, node: c_ast.BinaryOp) -> bool:
        """test = the comparison, or its opposite: then true is given."""
        left, right, operation = node.left, node.right, node.op
        if operation in ("==", "!="):
            value = self.const(right)
            if value is not None and 0xFFFF - value <= MOST:
                self.expression(left)
                self.emit("NOT")
                self.emit("EQI", 0xFFFF - value)
            else:
                self.operate("EQ", left, right)
            return operation == "!="
        shifted = self.shifted_limit(operation, self.const(right))
        if shifted is not None:
            # a < m << k is a >> k < m
            self.expression(left)
            self.emit("SHIFT", 16 + shifted[1])
            self.emit("LTUI", shifted[0])
            return operation in (">", ">=")
        if operation in (">", "<="):
            # a > c is !(a < c + 1)
            value = self.const(right)
            if value is not None and value < 0xFFFF:
                self.operate("LTU", left, c_ast.Constant("int", str(value + 1), node.coord))
                return operation == ">"
            self.operate("LTU", right, left)
            return operation == "<="
        value = self.const(right)
        if value is not None and value > MOST:
            # a < c is !(c - 1 < a)
            self.operate("LTU", c_ast.Constant("int", str(value - 1), node.coord), left)
            return operation == "<"
        self.operate("LTU", left, right)
        return operation == ">="

    def shifted_limit(self, operation: str, value: int | None) -> tuple[int, int] | None:
        """m and k of a limit m << k that is too long for an instruction while m is not."""
        if value is None:
            return None
        limit = value + (operation in (">", "<="))
        shift = (limit & -limit).bit_length() - 1
        return (limit >> shift, shift) if MOST < limit <= 0xFFFF and limit >> shift <= MOST else None

    def branch(self, node: c_ast.Node, target: str, when: bool) -> None:
        """Jumps to `target` if the condition is `when`."""
        value = self.const(node)
        if value is not None:
            if bool(value) == when:
                self.emit("JUMP", target)
        elif isinstance(node, c_ast.UnaryOp) and node.op == "!":
            self.branch(node.expr, target, not when)
        elif isinstance(node, c_ast.BinaryOp) and node.op in ("&&", "||"):
            if (node.op == "||") == when:
                self.branch(node.left, target, when)
                self.branch(node.right, target, when)
            else:
                skip = self.label()
                self.branch(node.left, skip, not when)
                self.branch(node.right, target, when)
                self.place(skip)
        elif isinstance(node, c_ast.BinaryOp) and node.op in COMPARES:
            zero = self.const(node.right) == 0
            if zero and node.op in ("==", "!="):
                self.branch(node.left, target, when == (node.op == "!="))
                return
            opposite = self.compare(node)
            self.emit("JNZ" if when != opposite else "JZ", target)
        else:
            if not self.high_bits(node):
                self.expression(node)
            self.emit("JNZ" if when else "JZ", target)

    def high_bits(self, node: c_ast.Node) -> bool:
        """acc is not 0 if the high bits of a value that a mask names are not: those below are shifted out."""
        mask = self.const(node.right) if isinstance(node, c_ast.BinaryOp) and node.op == "&" else None
        if mask is None or mask <= MOST or (mask | mask - 1) != 0xFFFF:
            return False
        self.expression(node.left)
        self.emit("SHIFT", 16 + (mask & -mask).bit_length() - 1)
        return True

    # ---- calls ---------------------------------------------------------------------------------
    def call(self, node: c_ast.FuncCall, wanted: bool) -> None:
        name = node.name.name
        arguments = node.args.exprs if node.args else []
        expected = INTRINSICS.get(name)
        if expected is None:
            expected = len(self.unit.functions[name].parameters)
        if len(arguments) != expected:
            fail(node, f"{name} takes {expected} arguments")
        if name == "io_read":
            self.read(arguments[0])
        elif name == "io_write":
            if wanted:
                fail(node, "io_write gives nothing")
            self.write(arguments[0], arguments[1])
        else:
            called = self.unit.functions[name]
            if wanted and not called.gives:
                fail(node, f"{name} gives nothing")
            self.pass_arguments(called, arguments)
            self.emit("CALL", name)

    def pass_arguments(self, called: Function, arguments: list[c_ast.Node]) -> None:
        """Arguments with calls first, as these may use the called function's variables, or lie over them."""
        if not arguments:
            return
        mark = self.used
        last = len(arguments) - 1
        calling = [i for i, argument in enumerate(arguments) if calls_function(argument)]
        if calling == [last] and not last:
            calling = []
        places = [f"{called.name}:{name}" for name in called.parameters]
        waiting: dict[int, str] = {}
        for i in calling:
            self.expression(arguments[i])
            if i == calling[-1] and i != last:
                self.emit("STORE", (places[i], 0))
            else:
                waiting[i] = self.temporary()
                self.emit("STORE", (waiting[i], 0))
        for i, argument in enumerate(arguments):
            if i in waiting:
                self.emit("LOAD", (waiting[i], 0))
            elif i not in calling:
                self.expression(argument)
            else:
                continue
            if i != last:
                self.emit("STORE", (places[i], 0))
        self.used = mark

    def register(self, address: c_ast.Node) -> int | None:
        """Operand of IN and OUT for a constant address."""
        value = self.const(address)
        return value if value is not None and value <= MOST // 2 else None

    def read(self, address: c_ast.Node) -> None:
        register = self.register(address)
        if register is not None:
            self.emit("IN", register)
            return
        self.expression(address)
        self.emit("INX")

    def write(self, address: c_ast.Node, value: c_ast.Node) -> None:
        register = self.register(address)
        if register is not None:
            self.expression(value)
            self.emit("OUT", register)
            return
        self.indexed(address, value, Instruction("OUTX"))

    def indexed(self, index: c_ast.Node, value: c_ast.Node, store: Instruction) -> None:
        """x = index, acc = value, then `store`."""
        mark = self.used
        simple = self.simple(index)
        if isinstance(simple, tuple):
            self.expression(value)
            self.emit("INDEX", simple)
        elif calls_function(value):  # that may use x
            self.expression(value)
            temporary = self.temporary()
            self.emit("STORE", (temporary, 0))
            self.expression(index)
            self.emit("SETX")
            self.emit("LOAD", (temporary, 0))
        else:
            self.expression(index)
            self.emit("SETX")
            self.expression(value)
        self.out.append(store)
        self.used = mark


def calls_function(node: c_ast.Node) -> bool:
    """Whether evaluating the node calls a function that is no intrinsic one."""
    if isinstance(node, c_ast.FuncCall) and node.name.name not in INTRINSICS:
        return True
    return any(calls_function(child) for _, child in node.children())


def has_call(node: c_ast.Node) -> bool:
    """Whether evaluating the node calls a function, or does input or output."""
    if isinstance(node, c_ast.FuncCall):
        return True
    return any(has_call(child) for _, child in node.children())
