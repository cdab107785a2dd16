"""Parses the expressions that `texelscope trace` prints and evaluates them in a number format.

Grammar and meaning as in C: || && & == != < <= > >= + - * / and unary - !, and the functions floor, trunc, ceil,
round_even, single (the nearest float32), lesser, greater, choose, modulo (Euclidean). Two integers stay integers; beside a real an integer becomes
a real; a quotient is a real.
"""
import math
import re

TOKEN = re.compile(
    r"\s*(?:(?P<number>\((?:-[\d.]+(?:e[+-]?\d+)?(?:/\d+)?|-?\d+/\d+|-inf|-nan)\)|\d[\d.]*(?:e[+-]?\d+)?)"
    r"|(?P<name>[^\W\d]\w*)|(?P<symbol>\|\||&&|==|!=|<=|>=|[-+*/<>&!(),]))"
)
LEVELS = [["||"], ["&&"], ["&"], ["==", "!="], ["<", "<=", ">", ">="], ["+", "-"], ["*", "/"]]
ROUNDINGS = {"floor": math.floor, "trunc": math.trunc, "ceil": math.ceil, "round_even": round}
FUNCTIONS = set(ROUNDINGS) | {"single", "lesser", "greater", "choose", "modulo"}


def tokens(text):
    at, out = 0, []
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise ValueError(f"cannot read '{text[at:]}'")
        out.append((match.lastgroup, match.group(match.lastgroup)))
        at = match.end()
    return out


class Evaluator:
    """`leaf(text)` gives the value of the next name or number."""

    def __init__(self, fmt, leaf):
        self.fmt, self.leaf = fmt, leaf

    def value(self, text):
        self.tokens, self.at = tokens(text), 0
        value = self.level(0)
        if self.at != len(self.tokens):
            raise ValueError(f"'{text}' goes on after its end")
        return value

    def symbol(self):
        kind, text = self.tokens[self.at] if self.at < len(self.tokens) else ("end", "")
        return text if kind == "symbol" else None

    def take(self, symbol):
        if self.symbol() != symbol:
            raise ValueError(f"expected {symbol}")
        self.at += 1

    def level(self, n):
        if n == len(LEVELS):
            return self.unary()
        left = self.level(n + 1)
        while self.symbol() in LEVELS[n]:
            symbol = self.symbol()
            self.at += 1
            left = self.apply(symbol, left, self.level(n + 1))
        return left

    def unary(self):
        if self.symbol() == "-":
            self.at += 1
            a = self.unary()
            return -a if isinstance(a, int) else self.fmt.negate(a)
        if self.symbol() == "!":
            self.at += 1
            return not self.unary()
        return self.primary()

    def primary(self):
        if self.symbol() == "(":
            self.at += 1
            value = self.level(0)
            self.take(")")
            return value
        kind, text = self.tokens[self.at]
        self.at += 1
        if kind == "name" and text in FUNCTIONS and self.symbol() == "(":
            return self.call(text)
        if kind == "symbol":
            raise ValueError(f"unexpected {text}")
        return self.leaf(text.strip("()"))

    def call(self, name):
        self.take("(")
        given = [self.level(0)]
        while self.symbol() == ",":
            self.at += 1
            given.append(self.level(0))
        self.take(")")
        if name in ROUNDINGS:
            a = given[0]
            return a if isinstance(a, int) else self.fmt.to_whole(a, ROUNDINGS[name])
        if name == "single":
            return self.fmt.single(self.as_real(given[0]))
        if name == "modulo":
            return given[0] % given[1]
        if name == "choose":
            return given[1] if given[0] else given[2]
        a, b = given
        first = self.apply("<", b, a) if name == "lesser" else self.apply("<", a, b)
        return b if first else a

    def apply(self, symbol, a, b):
        if symbol == "&&":
            return a and b
        if symbol == "||":
            return a or b
        if isinstance(a, int) and isinstance(b, int) and symbol != "/":
            return self.whole(symbol, a, b)
        return self.real(symbol, self.as_real(a), self.as_real(b))

    def as_real(self, a):
        return self.fmt.from_integer(a) if isinstance(a, int) else a

    @staticmethod
    def whole(symbol, a, b):
        return {
            "+": lambda: a + b, "-": lambda: a - b, "*": lambda: a * b, "&": lambda: a & b,
            "<": lambda: a < b, "<=": lambda: a <= b, ">": lambda: a > b, ">=": lambda: a >= b,
            "==": lambda: a == b, "!=": lambda: a != b,
        }[symbol]()

    def real(self, symbol, a, b):
        fmt = self.fmt
        return {
            "+": lambda: fmt.add(a, b), "-": lambda: fmt.subtract(a, b),
            "*": lambda: fmt.multiply(a, b), "/": lambda: fmt.divide(a, b),
            "<": lambda: fmt.less(a, b), ">": lambda: fmt.less(b, a),
            "<=": lambda: fmt.less(a, b) or fmt.equal(a, b), ">=": lambda: fmt.less(b, a) or fmt.equal(a, b),
            "==": lambda: fmt.equal(a, b), "!=": lambda: not fmt.equal(a, b),
        }[symbol]()
