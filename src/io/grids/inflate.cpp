#include <array>
#include <span>

#include "io/grids/readers.hpp"

namespace batten::grids {
namespace {

/// Bits from the low end of each byte.
class Bits {
public:
    Bits(std::string_view bytes, const std::string& source) : bytes_(bytes), source_(source) {}

    unsigned take(int count) {
        unsigned value = 0;
        for (int i = 0; i < count; ++i) {
            if (at_ / 8 >= bytes_.size()) throw damaged("end of data");
            const unsigned bit = static_cast<unsigned char>(bytes_[at_ / 8]) >> (at_ % 8) & 1;
            value |= bit << i;
            ++at_;
        }
        return value;
    }
    void to_byte() { at_ = (at_ + 7) / 8 * 8; }
    Error damaged(const char* value) const {
        return not_a_picture(source_, value, "the packed pixels are damaged");
    }

private:
    std::string_view bytes_;
    const std::string& source_;
    std::size_t at_ = 0;
};

/// A canonical Huffman code [RFC1951, 3.2.2].
class Code {
public:
    explicit Code(std::span<const unsigned char> lengths) : symbols_(lengths.size()) {
        for (const unsigned char length : lengths) ++counts_[length];
        counts_[0] = 0;
        std::array<unsigned, 17> starts{};
        for (std::size_t l = 1; l < 16; ++l) starts[l + 1] = starts[l] + counts_[l];
        for (std::size_t s = 0; s < lengths.size(); ++s) {
            if (lengths[s] > 0) symbols_[starts[lengths[s]]++] = static_cast<unsigned>(s);
        }
    }
    unsigned next(Bits& bits) const {
        unsigned code = 0, first = 0, index = 0;
        for (std::size_t l = 1; l < 16; ++l) {
            code |= bits.take(1);
            if (code < first + counts_[l]) return symbols_[index + (code - first)];
            index += counts_[l];
            first = (first + counts_[l]) << 1;
            code <<= 1;
        }
        throw bits.damaged("no such code");
    }

private:
    std::array<unsigned, 16> counts_{};
    std::vector<unsigned> symbols_;
};

struct Codes {
    Code lengths, distances;
};

Codes fixed_codes() {
    std::vector<unsigned char> lengths(288, 8);
    for (std::size_t s = 144; s < 256; ++s) lengths[s] = 9;
    for (std::size_t s = 256; s < 280; ++s) lengths[s] = 7;
    return {Code(lengths), Code(std::vector<unsigned char>(30, 5))};
}

Codes read_codes(Bits& bits) {
    constexpr unsigned char places[] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                        11, 4,  12, 3, 13, 2, 14, 1, 15};
    const std::size_t literals = bits.take(5) + 257, distances = bits.take(5) + 1;
    const std::size_t known = bits.take(4) + 4;
    std::vector<unsigned char> short_lengths(19, 0);
    for (std::size_t i = 0; i < known; ++i) {
        short_lengths[places[i]] = static_cast<unsigned char>(bits.take(3));
    }
    const Code code(short_lengths);
    std::vector<unsigned char> lengths;
    while (lengths.size() < literals + distances) {
        const unsigned symbol = code.next(bits);
        if (symbol < 16) {
            lengths.push_back(static_cast<unsigned char>(symbol));
            continue;
        }
        if (symbol == 16 && lengths.empty()) throw bits.damaged("nothing to repeat");
        const unsigned char value = symbol == 16 ? lengths.back() : 0;
        const unsigned times = symbol == 16   ? bits.take(2) + 3
                               : symbol == 17 ? bits.take(3) + 3
                                              : bits.take(7) + 11;
        lengths.insert(lengths.end(), times, value);
    }
    if (lengths.size() != literals + distances) throw bits.damaged("too many lengths");
    const std::span<const unsigned char> all(lengths);
    return {Code(all.first(literals)), Code(all.subspan(literals))};
}

/// One packed block [RFC1951, 3.2.5].
void unpack_block(Bits& bits, const Codes& codes, std::size_t most, std::string& out) {
    constexpr unsigned lengths[] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                    31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
    constexpr int length_bits[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                   2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
    constexpr unsigned distances[] = {1,   2,   3,   4,   5,   7,    9,    13,   17,   25,
                                      33,  49,  65,  97,  129, 193,  257,  385,  513,  769,
                                      1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
    while (true) {
        const unsigned symbol = codes.lengths.next(bits);
        if (symbol == 256) return;
        if (symbol < 256) {
            out += static_cast<char>(symbol);
        } else {
            if (symbol > 285) throw bits.damaged("no such length");
            const unsigned length = lengths[symbol - 257] + bits.take(length_bits[symbol - 257]);
            const unsigned far = codes.distances.next(bits);
            if (far > 29) throw bits.damaged("no such distance");
            const unsigned distance =
                distances[far] + bits.take(far < 2 ? 0 : static_cast<int>(far / 2 - 1));
            if (distance > out.size()) throw bits.damaged("a distance before the start");
            for (unsigned i = 0; i < length; ++i) out += out[out.size() - distance];
        }
        if (out.size() > most) throw bits.damaged("more pixels than declared");
    }
}

}  // namespace

std::string unpack(std::string_view stream, std::size_t most, const std::string& source) {
    Bits bits(stream, source);
    if (bits.take(4) != 8) throw bits.damaged("another packing");
    bits.take(12);
    std::string out;
    while (true) {
        const bool is_last = bits.take(1) == 1;
        const unsigned kind = bits.take(2);
        if (kind == 0) {
            bits.to_byte();
            const unsigned length = bits.take(16);
            if (bits.take(16) != (length ^ 0xffff)) throw bits.damaged("a wrong length");
            for (unsigned i = 0; i < length; ++i) out += static_cast<char>(bits.take(8));
            if (out.size() > most) throw bits.damaged("more pixels than declared");
        } else if (kind < 3) {
            unpack_block(bits, kind == 1 ? fixed_codes() : read_codes(bits), most, out);
        } else {
            throw bits.damaged("no such block");
        }
        if (is_last) return out;
    }
}

}  // namespace batten::grids
