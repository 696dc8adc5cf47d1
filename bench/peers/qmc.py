# SPDX-License-Identifier: GPL-3.0-or-later
# python3 qmc.py RADIUS: fills the unit square with scipy.stats.qmc.PoissonDisk and prints the CPU
# seconds, then one point per line.
import sys
import time

try:
    from scipy.stats import qmc
except ImportError:
    sys.exit(1)
engine = qmc.PoissonDisk(2, radius=float(sys.argv[1]), seed=1)
start = time.process_time()
points = engine.fill_space()
print(time.process_time() - start)
for x, y in points:
    print(x, y)
