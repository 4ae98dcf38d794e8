#include "hsr/io/read/gzip.h"

#include <sys/resource.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

namespace hsr::internal::read {

namespace {

/// Inflated bytes in pieces, so that nothing is copied twice and nothing is allocated before it is needed.
struct Pieces {
  static constexpr std::size_t piece = std::size_t{1} << 22;
  std::vector<Bytes> full;
  std::size_t used_of_last = 0;

  std::size_t size() const { return full.empty() ? 0 : (full.size() - 1) * piece + used_of_last; }
  Bytes joined() const {
    Bytes all = Bytes::of_size(size());
    for (std::size_t i = 0; i < full.size(); ++i)
      std::memcpy(all.data.get() + i * piece, full[i].data.get(), i + 1 == full.size() ? used_of_last : piece);
    return all;
  }
};

struct Inflater {
  z_stream stream{};
  bool ready = false;
  Inflater() { ready = inflateInit2(&stream, 15 + 16) == Z_OK; }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() {
    if (ready) inflateEnd(&stream);
  }
};

/// What the last member says of its size, modulo 2^32: no more than a hint, as nobody has checked it yet.
std::size_t size_at_end(std::string_view in) {
  if (in.size() < 18) return 0;
  std::size_t size = 0;
  for (std::size_t k = 0; k < 4; ++k)
    size |= static_cast<std::size_t>(static_cast<unsigned char>(in[in.size() - 4 + k])) << (8 * k);
  // Zeros behind the data, or something else: what comes out is counted in any case.
  return size / 2000 > in.size() ? 0 : size;
}

}  // namespace

std::size_t most_inflated() {
  constexpr std::size_t most = std::size_t{1} << 32;
  rlimit memory{};
  if (::getrlimit(RLIMIT_DATA, &memory) != 0 || memory.rlim_cur == RLIM_INFINITY) return most;
  return std::min(most, static_cast<std::size_t>(memory.rlim_cur / 4));
}

bool is_gzip(std::string_view bytes) { return bytes.size() >= 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b'; }

Bytes gunzip(const Source& source, std::size_t most) {
  const std::string_view in = source.bytes;
  Inflater inflater;
  if (!inflater.ready) source.refuse("", "cannot be inflated: zlib does not start");
  z_stream& z = inflater.stream;
  std::size_t at = 0;
  Pieces out;
  const auto refuse = [&](const std::string& what) {
    source.refuse("byte " + std::to_string(at - z.avail_in), "found " + what + ", expected gzip data");
  };
  const std::string too_large = "gzip data that inflates to more than " + std::to_string(most) + " bytes";
  if (size_at_end(in) > most) refuse(too_large);
  for (;;) {
    if (z.avail_in == 0 && at < in.size()) {
      const std::size_t n = std::min<std::size_t>(in.size() - at, std::numeric_limits<uInt>::max());
      // zlib does not write through next_in; its type is older than const.
      z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(in.data() + at));
      z.avail_in = static_cast<uInt>(n);
      at += n;
    }
    if (out.full.empty() || out.used_of_last == Pieces::piece) {
      out.full.push_back(Bytes::of_size(Pieces::piece));
      out.used_of_last = 0;
    }
    z.next_out = reinterpret_cast<Bytef*>(out.full.back().data.get() + out.used_of_last);
    z.avail_out = static_cast<uInt>(Pieces::piece - out.used_of_last);
    const int status = inflate(&z, Z_NO_FLUSH);
    out.used_of_last = Pieces::piece - z.avail_out;
    if (out.size() > most) refuse(too_large);
    if (status == Z_STREAM_END) {
      const std::string_view rest = in.substr(at - z.avail_in);
      if (rest.find_first_not_of('\0') == std::string_view::npos) return out.joined();
      if (!is_gzip(rest)) refuse("something else behind the end of the gzip data");
      inflateReset(&z);
    } else if (status != Z_OK && status != Z_BUF_ERROR) {
      refuse(std::string("damaged gzip data (") + (z.msg ? z.msg : "zlib error") + ")");
    } else if (z.avail_in == 0 && at == in.size() && z.avail_out != 0) {
      refuse("the end of the file inside the gzip data");
    }
  }
}

}  // namespace hsr::internal::read
