# SPDX-License-Identifier: GPL-3.0-or-later
# Rscript spatstat.R RADIUS: fills the unit square with spatstat.random's rSSI and prints the CPU
# seconds, then one point per line.
if (!suppressWarnings(suppressMessages(require(spatstat.random, quietly = TRUE)))) quit(status = 1)
radius <- as.numeric(commandArgs(trailingOnly = TRUE)[1])
start <- proc.time()
points <- rSSI(radius, Inf, win = owin(c(0, 1), c(0, 1)), giveup = 1000)
used <- proc.time() - start
cat(used[["user.self"]] + used[["sys.self"]], "\n")
cat(sprintf("%.17g %.17g\n", points$x, points$y), sep = "")
