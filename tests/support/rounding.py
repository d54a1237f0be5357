"""Code under another rounding mode of the processor, or with subnormal numbers flushed to zero."""

import ctypes
import platform
import sys
from contextlib import contextmanager

import pytest

#: The rounding modes of <fenv.h> by their numbers on x86.
MODES = {"nearest": 0, "down": 0x400, "up": 0x800, "to zero": 0xC00}


#: Bits of the control register of SSE: results that are subnormal become zero, operands that are so are read as zero.
FLUSHED = {"results": 0x8000, "operands": 0x40, "both": 0x8040}


@contextmanager
def flushing(name):
    if platform.machine() not in ("x86_64", "AMD64") or sys.platform != "linux":
        pytest.skip("the control register is that of x86")
    libm, before = ctypes.CDLL("libm.so.6"), ctypes.create_string_buffer(64)
    libm.fegetenv(before)
    # the register is at the end of the 32 bytes that <fenv.h> keeps
    set_ = bytearray(before.raw)
    set_[28:32] = (int.from_bytes(before.raw[28:32], "little") | FLUSHED[name]).to_bytes(4, "little")
    libm.fesetenv(ctypes.create_string_buffer(bytes(set_), 64))
    try:
        assert float("9e-308") * float("1e-5") == 0 or name == "operands"
        yield
    finally:
        libm.fesetenv(before)


@contextmanager
def rounding(mode):
    if mode in FLUSHED:
        with flushing(mode):
            yield
        return
    if MODES[mode] and (platform.machine() not in ("x86_64", "AMD64") or sys.platform != "linux"):
        pytest.skip("the numbers of rounding modes are those of x86")
    libm = ctypes.CDLL("libm.so.6") if MODES[mode] else None
    try:
        assert libm is None or libm.fesetround(MODES[mode]) == 0
        yield
    finally:
        assert libm is None or libm.fesetround(0) == 0
