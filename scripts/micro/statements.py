# SPDX-License-Identifier: Apache-2.0
"""Statements to instructions; expressions are in code.py."""
from __future__ import annotations

from pycparser import c_ast

from micro.code import COMPARES, Generator, has_call
from micro.front import Function, Unit, fail, fold
from micro.isa import MOST, Instruction, Label


class FunctionGenerator(Generator):
    """The code of one function, whole."""

    def function_code(self) -> list[Instruction | Label]:
        self.place(self.function.name)
        if self.function.parameters:
            self.emit("STORE", (f"{self.function.name}:{self.function.parameters[-1]}", 0))
        self.statement(self.function.body)
        self.emit("RETURN")
        return self.out

    def statement(self, node: c_ast.Node | None) -> None:
        if node is None or isinstance(node, c_ast.EmptyStatement):
            return
        handler = getattr(self, f"on_{type(node).__name__}", None)
        if handler is None:
            fail(node, f"{type(node).__name__} is not in the language here")
        handler(node)

    def on_Compound(self, node: c_ast.Compound) -> None:  # noqa: N802
        for each in node.block_items or []:
            self.statement(each)

    def on_DeclList(self, node: c_ast.DeclList) -> None:  # noqa: N802
        for each in node.decls:
            self.statement(each)

    def on_Decl(self, node: c_ast.Decl) -> None:  # noqa: N802
        if node.init is not None:
            self.expression(node.init)
            self.emit("STORE", (f"{self.function.name}:{node.name}", 0))

    def on_Assignment(self, node: c_ast.Assignment) -> None:  # noqa: N802
        value = node.rvalue
        if node.op != "=":
            if isinstance(node.lvalue, c_ast.ArrayRef) and has_call(node.lvalue.subscript):
                fail(node, "this index would be evaluated twice, and it has a call: give it a variable of its own")
            value = c_ast.BinaryOp(node.op[:-1], node.lvalue, node.rvalue, node.coord)
        if isinstance(node.lvalue, c_ast.ID):
            place: tuple[str, int] | None = (self.variable(node.lvalue), 0)
        elif isinstance(node.lvalue, c_ast.ArrayRef):
            index = self.const(node.lvalue.subscript)
            place = None if index is None else (self.array(node.lvalue), index)
        else:
            fail(node, "only variables and words of arrays are assigned")
        step = self.step_of(node.lvalue, value)
        if place is not None and step:
            self.emit(step, place)
        elif place is not None:
            self.expression(value)
            self.emit("STORE", place)
        else:
            subscript, offset = self.split_index(node.lvalue.subscript)
            self.indexed(subscript, value, Instruction("STOREX", (self.array(node.lvalue), offset)))

    def step_of(self, variable: c_ast.Node, value: c_ast.Node) -> str | None:
        """INC or DEC if `value` is the variable and one more or less."""
        if not isinstance(value, c_ast.BinaryOp) or value.op not in ("+", "-"):
            return None
        for this, other in ((value.left, value.right), (value.right, value.left)):
            if self.const(other) in (1, 0xFFFF) and self.simple(this) == self.simple(variable):
                if value.op == "-" and other is value.left:
                    continue
                return "INC" if (value.op == "+") == (self.const(other) == 1) else "DEC"
        return None

    def on_UnaryOp(self, node: c_ast.UnaryOp) -> None:  # noqa: N802
        if node.op not in ("++", "--", "p++", "p--"):
            fail(node, "an expression without effect")
        one = c_ast.Constant("int", "1", node.coord)
        self.on_Assignment(c_ast.Assignment(node.op[-1] + "=", node.expr, one, node.coord))

    def on_FuncCall(self, node: c_ast.FuncCall) -> None:  # noqa: N802
        self.call(node, False)

    def on_If(self, node: c_ast.If) -> None:  # noqa: N802
        no = self.label()
        self.branch(node.cond, no, False)
        self.statement(node.iftrue)
        if node.iffalse is not None:
            end = self.label()
            self.emit("JUMP", end)
            self.place(no)
            self.statement(node.iffalse)
            self.place(end)
        else:
            self.place(no)

    def on_While(self, node: c_ast.While) -> None:  # noqa: N802
        again, end = self.label(), self.label()
        self.place(again)
        self.branch(node.cond, end, False)
        self.loop(node.stmt, again, end)
        self.emit("JUMP", again)
        self.place(end)

    def on_DoWhile(self, node: c_ast.DoWhile) -> None:  # noqa: N802
        again, test, end = self.label(), self.label(), self.label()
        self.place(again)
        self.loop(node.stmt, test, end)
        self.place(test)
        self.branch(node.cond, again, True)
        self.place(end)

    def on_For(self, node: c_ast.For) -> None:  # noqa: N802
        again, step, end = self.label(), self.label(), self.label()
        self.statement(node.init)
        enters = self.enters(node)
        self.place(again)
        if node.cond is not None and not enters:
            self.branch(node.cond, end, False)
        self.loop(node.stmt, step, end)
        self.place(step)
        self.statement(node.next)
        if enters:
            self.branch(node.cond, again, True)
        else:
            self.emit("JUMP", again)
        self.place(end)

    def enters(self, node: c_ast.For) -> bool:
        """Whether the condition of a loop is true for the constant that its variable begins with."""
        if not isinstance(node.init, c_ast.Assignment) or not isinstance(node.cond, c_ast.BinaryOp):
            return False
        first, last = self.const(node.init.rvalue), self.const(node.cond.right)
        same = (isinstance(node.init.lvalue, c_ast.ID) and isinstance(node.cond.left, c_ast.ID)
                and node.init.lvalue.name == node.cond.left.name and node.init.op == "=")
        return same and first is not None and last is not None and node.cond.op in COMPARES and bool(
            fold(node.cond, first, last))

    def loop(self, body: c_ast.Node, on: str, out: str) -> None:
        self.loops.append((on, out))
        self.statement(body)
        self.loops.pop()

    def on_Break(self, node: c_ast.Break) -> None:  # noqa: N802
        if not self.loops:
            fail(node, "break outside of a loop")
        self.emit("JUMP", self.loops[-1][1])

    def on_Continue(self, node: c_ast.Continue) -> None:  # noqa: N802
        if not self.loops or not self.loops[-1][0]:
            fail(node, "continue outside of a loop")
        self.emit("JUMP", self.loops[-1][0])

    def on_Return(self, node: c_ast.Return) -> None:  # noqa: N802
        if (node.expr is not None) != self.function.gives:
            fail(node, f"{self.function.name} gives {'a' if self.function.gives else 'no'} result")
        if node.expr is not None:
            self.expression(node.expr)
        self.emit("RETURN")

    def on_Switch(self, node: c_ast.Switch) -> None:  # noqa: N802
        """Differences to one case after another in the accumulator, then the bodies one behind the other."""
        items = node.stmt.block_items or []
        places: list[tuple[c_ast.Node, str]] = [(each, self.label()) for each in items]
        end = self.label()
        default = end
        self.expression(node.cond)
        taken = 0                       # what has been subtracted
        for each, place in places:
            if isinstance(each, c_ast.Default):
                default = place
                continue
            if not isinstance(each, c_ast.Case):
                fail(each, "a switch has cases only")
            case = self.const(each.expr)
            if case is None:
                fail(each, "a case is a constant")
            self.subtract(case - taken)
            taken = case
            self.emit("JZ", place)
        self.emit("JUMP", default)
        outer = self.loops[-1][0] if self.loops else ""
        self.loops.append((outer, end))
        for each, place in places:
            self.place(place)
            for statement in each.stmts or []:
                self.statement(statement)
        self.loops.pop()
        self.place(end)

    def subtract(self, number: int) -> None:
        """acc = acc - number, which may be negative, and too long for one instruction."""
        if number and -MOST <= number <= MOST:
            self.emit("SUBI" if number > 0 else "ADDI", abs(number))
        elif number:
            mark = self.used
            value = self.temporary()
            self.emit("STORE", (value, 0))
            self.number(-number & 0xFFFF)
            self.emit("ADD", (value, 0))
            self.used = mark


def generate(unit: Unit) -> dict[str, list[Instruction | Label]]:
    """The code of every function; their temporaries become variables of theirs."""
    return {name: FunctionGenerator(unit, function).function_code()
            for name, function in unit.functions.items()}


__all__ = ["Function", "generate"]
