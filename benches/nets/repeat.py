"""The protocol between an implementation in Python and bench.mjs, the same as ../repeat.rs."""

import json
import sys
import time


def repeat(result, work):
    """Prints the result to compare, then times as many repetitions as each line of the input asks for."""
    print(json.dumps([float(number) for number in result]), flush=True)
    for line in sys.stdin:
        times = []
        for _ in range(int(line)):
            start = time.perf_counter()
            work()
            times.append((time.perf_counter() - start) * 1e3)
        print(json.dumps(times), flush=True)
