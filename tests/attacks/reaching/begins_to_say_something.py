"""Announces a long message when it is imported, says a little of it, and is silent.

verdict: refused
says: when it imported
"""

import os
import struct
import time

for descriptor in range(3, 64):
    try:
        os.write(descriptor, struct.pack("!i", 1000) + b"Well,")
    except OSError:
        continue
time.sleep(3600)
