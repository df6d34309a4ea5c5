heading "Tools beside their library"
run tool_time $(size 256 "512 2048")

text <<'END'
Seconds of a tool on a file and of its library on heights in memory, one thread, and the peak memory of the tool beyond that of its
start, in fields of N × N doubles:
END
table tool_time-1
text <<'END'
What a tool does not need stays in the file: tables are copied from file to file, or not at all. At 512² half the
time of a short run is the start of the program.
END
