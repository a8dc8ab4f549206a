"""Ends the process that imports it, with the exit code of success.

verdict: refused
says: when it imported
quick: 1
"""

import os

os._exit(0)
