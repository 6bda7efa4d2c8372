/* Escapes untrusted text (file names, strings of programs and drivers) as one line without terminal control
   sequences. C, for the doors, and C++. Any thread. */
#pragma once
#include <stddef.h>
#include <stdio.h>
#include <string.h>

/* Length in bytes of the well-formed UTF-8 character at `text`, which has `length` bytes; sets its code
   point. 0 if it is malformed (RFC 3629: no overlong forms, no surrogates). */
static inline size_t glurayCharacter(const unsigned char* text, size_t length, unsigned* code) {
  static const struct {
    unsigned char mask, lead;
    unsigned least;
  } forms[] = {{0x80, 0x00, 0}, {0xe0, 0xc0, 0x80}, {0xf0, 0xe0, 0x800}, {0xf8, 0xf0, 0x10000}};
  for (size_t more = 0; more < 4 && more < length; ++more) {
    if ((text[0] & forms[more].mask) != forms[more].lead) continue;
    *code = text[0] & (unsigned char)~forms[more].mask;
    for (size_t i = 1; i <= more; ++i) {
      if ((text[i] & 0xc0) != 0x80) return 0;
      *code = *code << 6 | (text[i] & 0x3f);
    }
    const int surrogate = *code >= 0xd800 && *code < 0xe000;
    return *code < forms[more].least || *code > 0x10ffff || surrogate ? 0 : more + 1;
  }
  return 0;
}

/* Whether the character may control a terminal or the layout of text: C0 and C1 controls, line and paragraph
   separators, bidirectional controls. */
static inline int glurayIsControl(unsigned code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029 || code == 0x061c ||
         code == 0x200e || code == 0x200f || (code >= 0x202a && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

/* Writes `text` into `out`, with control characters and bytes that are not UTF-8 escaped (\n, \t, \x1b,
   \u202e). Truncates to `size` bytes (at least 1), including the terminating zero. Returns the bytes written
   without that zero: at most four times `length`. */
static inline size_t glurayPrintable(char* out, size_t size, const char* text, size_t length) {
  size_t used = 0;
  while (length > 0) {
    unsigned code = 0;
    const size_t bytes = glurayCharacter((const unsigned char*)text, length, &code);
    char word[8];
    if (bytes == 0)
      snprintf(word, sizeof word, "\\x%02x", (unsigned)(unsigned char)*text);
    else if (code == '\n' || code == '\t')
      snprintf(word, sizeof word, "\\%c", code == '\n' ? 'n' : 't');
    else if (glurayIsControl(code))
      snprintf(word, sizeof word, code < 0x80 ? "\\x%02x" : "\\u%04x", code & 0xffff);
    else
      snprintf(word, sizeof word, "%.*s", (int)bytes, text);
    const size_t step = strlen(word);
    if (used + step >= size) break;
    memcpy(out + used, word, step);
    used += step;
    text += bytes ? bytes : 1, length -= bytes ? bytes : 1;
  }
  out[used] = 0;
  return used;
}

#ifdef __cplusplus
#include <string>
#include <string_view>

namespace gluray {

/// `text` escaped by glurayPrintable().
inline std::string printable(std::string_view text) {
  std::string line(4 * text.size() + 1, '\0');
  line.resize(glurayPrintable(line.data(), line.size(), text.data(), text.size()));
  return line;
}

}  // namespace gluray
#endif
