# What docs/library.md links for readers of the pages: headers, functions, types, and the examples,
# which are shown in full. Where one of them has another name by now, Doxygen warns.
s#`(roomatlas/[a-z0-9_/]+\.hpp)`#@ref \1 "\1"#g
s#`([a-z0-9_]+)\(\)`#@ref roomatlas::\1 "\1()"#g
s#`([A-Z][a-z]+[A-Za-z0-9]*)`#@ref roomatlas::\1 "\1"#g
s#^\[examples/([a-z_]+\.cpp)\].*#@include \1#
