#include "solver/output/picture_text.h"

#include <cmath>

namespace icebow {
namespace {

// Five columns a letter from " " to "~", two hexadecimal digits each, the lowest bit the topmost of eight
// dots.
constexpr char columns[] =
    "000000000000005F00000007000700147F147F14242A7F2A12231308646236495620500005030000001C2241000041221C00"
    "2A1C7F1C2A08083E080800503000000808080808000060600020100804023E5149453E00427F400072494949462141494D33"
    "1814127F1027454545393C4A49493141211109073649494936464949291E0036360000005636000008142241001414141414"
    "004122140802015909063E415D594E7C1211127C7F494949363E414141227F4141413E7F494949417F090909013E41415173"
    "7F0808087F00417F41002040413F017F081422417F404040407F021C027F7F0408107F3E4141413E7F090909063E4151215E"
    "7F09192946264949493203017F01033F4040403F1F2040201F3F4038403F631408146303047804036159494D43007F414141"
    "0204081020004141417F04020102044040404040000307080020545478407F284444383844444428384444287F3854545418"
    "00087E090218A4A49C787F0804047800447D40002040403D007F1028440000417F40007C047804787C080404783844444438"
    "FC1824241818242418FC7C08040408485454542404043F44243C4040207C1C2040201C3C4030403C44281028444C9090907C"
    "4464544C440008364100000077000000413608000201020402";

int hex(char digit) {
  return digit <= '9' ? digit - '0' : digit - 'A' + 10;
}

int column_of(char letter, int column) {
  const char* digits = columns + 10 * (letter - ' ') + 2 * column;
  return 16 * hex(digits[0]) + hex(digits[1]);
}

// A letter of several bytes is one "?".
std::string printable(const std::string& words) {
  std::string out;
  for (const char c : words)
    if ((c & 0xC0) != 0x80) out += c >= ' ' && c <= '~' ? c : '?';
  return out;
}

}  // namespace

double letter_dot(int width_px) {
  return std::max(1.0, std::round(width_px / 550.0));
}

double text_width(const std::string& words, double dot) {
  return (6.0 * static_cast<double>(printable(words).size()) - 1.0) * dot;
}

void draw_text(Canvas& canvas, const std::string& words, double left, double bottom, double dot,
               const Color& color) {
  for (const char letter : printable(words)) {
    for (int column = 0; column < 5; ++column)
      for (int row = 0, dots = column_of(letter, column); row < 8; ++row)
        if (dots >> row & 1) {
          const double x = left + column * dot, y = bottom + (6 - row) * dot;
          canvas.rectangle(x, y, x + dot, y + dot, color);
        }
    left += 6.0 * dot;
  }
}

}  // namespace icebow
