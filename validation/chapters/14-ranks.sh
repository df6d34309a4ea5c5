heading "Ranks: one surface by several processes"
run_script ranks_time validation/ranks_time $(size 600 "2048 4096")
text <<'END'
The same problems by threads and by ranks under mpirun, on two cores; the four ranks take turns, so that their memory counts and their
time does not. `convolution` is the padded one of a free contact alone; the others are whole runs with reading and writing. `ratio` is
the time over that of one process on two threads, `share` the memory of the largest rank over that of the same process. On 4096 cells a
side only the memory was measured, and the convolution.
END
table ranks_time-1
text <<'END'
The program fails unless all files have the same fields, to the last bit.
END
