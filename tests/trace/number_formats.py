"""The number formats, written again from their description: what each operation gives, rounded as it rounds."""
from fractions import Fraction
import math

import numpy as np

INTEGER_LIMIT = 4 * 10**18  # roundings saturate here


def saturated(whole):
    return max(-INTEGER_LIMIT, min(INTEGER_LIMIT, whole))


class Floating:
    """float64 or float32: every operation is rounded to the type."""

    def __init__(self, kind):
        self.kind = kind

    def from_text(self, text):
        return self.kind(text)

    def from_integer(self, i):
        return self.kind(i)

    def add(self, a, b):
        return a + b

    def subtract(self, a, b):
        return a - b

    def multiply(self, a, b):
        return a * b

    def divide(self, a, b):
        return a / b

    def negate(self, a):
        return -a

    def single(self, a):
        return self.kind(np.float32(a))

    def less(self, a, b):
        return bool(a < b)

    def equal(self, a, b):
        return bool(a == b)

    def same(self, a, b):
        return bool(a == b) or bool(a != a and b != b)

    def to_whole(self, a, rounding):
        if a != a:
            return 0
        if math.isinf(a):
            return INTEGER_LIMIT if a > 0 else -INTEGER_LIMIT
        return saturated(rounding(Fraction(float(a))))


class Exact:
    """Rational numbers; None is the number without a value."""

    def from_text(self, text):
        return None if text == "nan" else Fraction(text)

    def from_integer(self, i):
        return Fraction(i)

    def add(self, a, b):
        return None if a is None or b is None else a + b

    def subtract(self, a, b):
        return None if a is None or b is None else a - b

    def multiply(self, a, b):
        return None if a is None or b is None else a * b

    def divide(self, a, b):
        return None if a is None or not b else a / b

    def negate(self, a):
        return None if a is None else -a

    def single(self, a):
        return a

    def less(self, a, b):
        return a is not None and b is not None and a < b

    def equal(self, a, b):
        return a is not None and a == b

    def same(self, a, b):
        return a == b

    def to_whole(self, a, rounding):
        return 0 if a is None else saturated(rounding(a))


class Raw:
    """A fixed-point number as its whole number of units."""

    def __init__(self, units):
        self.units = units


class Fixed:
    """Fixed point: products and quotients toward zero; what leaves the range goes on with its true value."""

    END = (2**63 - 1) // 4

    def __init__(self, integer_bits, fraction_bits):
        self.one = 2**fraction_bits
        self.most = 2 ** (integer_bits + fraction_bits - 1) - 1

    def settle(self, units):
        if -self.most - 1 <= units <= self.most:
            return Raw(units)
        return Raw(max(-self.END, min(self.END, units)))

    def from_text(self, text):
        units = Fraction(text) * self.one
        if units.denominator != 1:
            raise ValueError(f"{text} is not a number of this format")
        return Raw(int(units))

    def from_integer(self, i):
        return self.settle(i * self.one)

    def add(self, a, b):
        return self.settle(a.units + b.units)

    def subtract(self, a, b):
        return self.settle(a.units - b.units)

    def multiply(self, a, b):
        return self.settle(math.trunc(Fraction(a.units * b.units, self.one)))

    def divide(self, a, b):
        if b.units == 0:
            return Raw(self.most if a.units > 0 else -self.most - 1 if a.units < 0 else 0)
        return self.settle(math.trunc(Fraction(a.units * self.one, b.units)))

    def negate(self, a):
        return self.settle(-a.units)

    def single(self, a):
        return a

    def less(self, a, b):
        return a.units < b.units

    def equal(self, a, b):
        return a.units == b.units

    same = equal

    def to_whole(self, a, rounding):
        return rounding(Fraction(a.units, self.one))


FORMATS = {
    "f64": Floating(np.float64),
    "f32": Floating(np.float32),
    "fx16.16": Fixed(16, 16),
    "fx8.8": Fixed(8, 8),
    "exact": Exact(),
}
