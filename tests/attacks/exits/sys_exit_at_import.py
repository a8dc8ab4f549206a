"""Leaves when it is imported.

verdict: refused
says: does not import: SystemExit
"""

import sys

sys.exit(0)
