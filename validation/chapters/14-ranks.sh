heading "Ranks: one contact by several processes"
run_script ranks_time validation/ranks_time $(size 600 "2048 4096")
text <<'END'
The same contact by threads and by ranks under mpirun, on two cores; the four ranks take turns, so that their memory counts and their
time does not. `contact` is the solution with its set-up, `whole` the run with reading and writing, `ratio` its time over that of one
process on two threads, `share` the memory of the largest rank over that of one process.
END
table ranks_time-1
text <<'END'
The program fails unless all files have the same fields, to the last bit.
END
