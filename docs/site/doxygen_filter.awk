# What Doxygen is shown instead of a header, line by line the same: placeholders such as <name> are
# no HTML tags, and a record's members are documented by the declaration of its fields. The comment
# at the top of the file comes last, as the description of the file.
NR > 1 && NR == heads + 2 && /^\/\// { head[++heads] = substr($0, 4) }
{
  line[NR] = $0
  if (match($0, /struct [A-Za-z]+/)) record = substr($0, RSTART + 7, RLENGTH - 7)
  owner[NR] = record
  if ($0 !~ /TOLMAN_FIELD\([A-Za-z_0-9]+, "/) next
  split($0, quoted, "\"")
  name = $0
  sub(/.*TOLMAN_FIELD\(/, "", name)
  sub(/,.*/, "", name)
  doc[record, name] = quoted[4] (quoted[2] == "" ? "" : " (" quoted[2] ")")
}
END {
  for (i = 1; i <= NR; ++i) {
    text = line[i]
    if (text ~ /\/\/\//) while (match(text, /<[a-z]+>/)) {
      text = substr(text, 1, RSTART - 1) "\\<" substr(text, RSTART + 1, RLENGTH - 2) "\\>" \
             substr(text, RSTART + RLENGTH)
    }
    if (text ~ /^  [A-Za-z].*;$/ && match(text, /[A-Za-z_0-9]+( = [^;]*)?;$/)) {
      name = substr(text, RSTART)
      sub(/[ ;].*/, "", name)
      if ((owner[i], name) in doc) text = text "  ///< " doc[owner[i], name]
    }
    print text
  }

  print "/** \\file"
  print "\\brief " head[1]
  print "\\verbatim"
  for (i = 1; i <= heads; ++i) print head[i]
  print "\\endverbatim */"
}
