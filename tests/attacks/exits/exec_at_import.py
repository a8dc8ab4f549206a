"""Becomes another program when it is imported.

verdict: refused
says: when it imported
"""

import os

os.execv("/bin/true", ["true"])
