#include "io/exchange/entries.hpp"

#include "batten/io/json.hpp"
#include "io/tables/utf8.hpp"

namespace batten::exchange {

std::string shown(const Value* value) {
    if (!value) return "missing";
    if (const std::string* text = value->text()) return utf8::shown(*text);
    if (const ValueList* list = value->list()) {
        return "a list of " + std::to_string(list->size());
    }
    return value->map() ? "a map" : dump_json(*value, JsonStyle::one_line);
}

void require_size(const Entries& entries, const char* key, std::size_t size, std::size_t needed) {
    if (size == needed) return;
    throw Error("curve.entry", entries.place(key), "a list of " + std::to_string(size),
                std::to_string(needed) + " entries are needed here");
}

}  // namespace batten::exchange
