#include "core/scene/json_tree.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

namespace texelscope {
namespace {

/// Reads the text for the parser and counts what it took.
class Reader {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Reader(const char* at, std::size_t* taken) : at_(at), taken_(taken) {}
    reference operator*() const { return *at_; }
    Reader& operator++() { return ++at_, ++*taken_, *this; }
    Reader operator++(int) { return std::exchange(*this, Reader(at_ + 1, (++*taken_, taken_))); }
    bool operator==(const Reader& other) const { return at_ == other.at_; }
    bool operator!=(const Reader& other) const { return at_ != other.at_; }

private:
    const char* at_;
    std::size_t* taken_;
};

/// What nlohmann says, without its own place and the text it read, which may be long.
std::string reason_of(std::string_view message) {
    const std::size_t expected = message.find("; expected ");
    if (message.find("out_of_range") != message.npos)
        return "a number is too large for a JSON number; write \"inf\" for infinity";
    if (message.find("UTF-8") != message.npos) return "is not JSON: a text is not valid UTF-8";
    if (message.find("unexpected end of input") != message.npos)
        return "is not JSON: it ends too early" +
               (expected == message.npos ? "" : ", expected " + std::string(message.substr(expected + 11)));
    if (expected != message.npos) return "is not JSON, expected " + std::string(message.substr(expected + 11));
    return "is not JSON: " +
           (message.find("control character") != message.npos
                ? std::string("a control character in a text must be escaped, or its quote is missing")
                : std::string("a number, text or word is not written as JSON has it"));
}

/// Takes the parser's events and builds the nodes. An event answers whether to go on.
class Builder {
public:
    using Node = JsonTree::Node;
    std::vector<Node> nodes;
    std::string characters;
    std::string fault;  // why it stopped, if it did

    Builder(std::string_view text, int first_line) : text_(text), line_(first_line) {}

    std::size_t taken = 0;
    [[nodiscard]] int line() {
        // A number ends one character late, which may be the line's end.
        const std::size_t last = taken > 0 ? taken - 1 : 0;
        for (; counted_ < last; ++counted_) {
            const void* found = std::memchr(text_.data() + counted_, '\n', last - counted_);
            if (found == nullptr) break;
            counted_ = static_cast<std::size_t>(static_cast<const char*>(found) - text_.data());
            ++line_;
        }
        counted_ = std::max(counted_, last);
        return line_;
    }

    bool null() { return add(JsonKind::null) != nullptr; }
    bool boolean(bool value) { return number(JsonKind::boolean, value ? 1 : 0); }
    bool number_integer(std::int64_t value) { return number(JsonKind::number, static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) { return number(JsonKind::number, static_cast<double>(value)); }
    bool number_float(double value, const std::string&) { return number(JsonKind::number, value); }
    bool string(const std::string& value) {
        Node* node = add(JsonKind::text);
        if (node != nullptr) node->text = keep(value);
        return node != nullptr;
    }
    bool binary(const std::vector<std::uint8_t>&) { return stop("is not JSON"); }
    bool start_object(std::size_t) { return open(JsonKind::object); }
    bool start_array(std::size_t) { return open(JsonKind::array); }
    bool end_array() {
        nodes[open_.back()].end = static_cast<std::uint32_t>(nodes.size());
        open_.pop_back();
        return true;
    }
    bool end_object() { return end_array(); }
    bool key(const std::string& value) {
        key_ = keep(value);
        key_line_ = line();
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& why) {
        return stop(reason_of(why.what()));
    }

private:
    bool stop(std::string why) {
        fault = std::move(why);
        return false;
    }
    JsonTree::Piece keep(const std::string& value) {
        const JsonTree::Piece piece{static_cast<std::uint32_t>(characters.size()),
                                    static_cast<std::uint32_t>(value.size())};
        characters += value;
        return piece;
    }
    Node* add(JsonKind kind) {
        if (nodes.size() >= kMaxJsonValues) {
            stop("has more than " + std::to_string(kMaxJsonValues) + " values");
            return nullptr;
        }
        Node& node = nodes.emplace_back();
        node.kind = kind;
        node.line = line();
        node.key = key_;
        node.key_line = key_line_;
        node.end = static_cast<std::uint32_t>(nodes.size());
        return &node;
    }
    bool number(JsonKind kind, double value) {
        Node* node = add(kind);
        if (node != nullptr) node->number = value;
        return node != nullptr;
    }
    bool open(JsonKind kind) {
        if (open_.size() >= kMaxJsonDepth)
            return stop("is nested more than " + std::to_string(kMaxJsonDepth) + " deep");
        if (add(kind) == nullptr) return false;
        open_.push_back(static_cast<std::uint32_t>(nodes.size() - 1));
        return true;
    }

    std::string_view text_;
    int line_;
    std::size_t counted_ = 0;  // characters of text_ whose line ends are in line_
    std::vector<std::uint32_t> open_;
    JsonTree::Piece key_;
    int key_line_ = 1;
};

/// A member of the object whose key an earlier member has, or its end.
JsonValue::Iterator repeated_key(const JsonValue& object) {
    std::vector<std::string_view> keys;
    for (const JsonValue member : object) keys.push_back(member.key());
    std::sort(keys.begin(), keys.end());
    const auto twice = std::adjacent_find(keys.begin(), keys.end());
    if (twice == keys.end()) return object.end();
    bool seen = false;
    for (JsonValue::Iterator at = object.begin(); at != object.end(); ++at)
        if ((*at).key() == *twice && std::exchange(seen, true)) return at;
    return object.end();
}

}  // namespace

std::string_view json_kind_name(JsonKind kind) {
    switch (kind) {
        case JsonKind::null: return "null";
        case JsonKind::boolean: return "true or false";
        case JsonKind::number: return "a number";
        case JsonKind::text: return "a text";
        case JsonKind::array: return "a list";
        case JsonKind::object: break;
    }
    return "an object";
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t kMost = 60;  // [bytes]
    std::string out = "'";
    std::size_t size = std::min(text.size(), kMost);
    while (size < text.size() && size > 0 && (text[size] & 0xc0) == 0x80) --size;  // never within a character
    for (const char c : text.substr(0, size)) out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    return out + (size < text.size() ? "...'" : "'");
}

JsonKind JsonValue::kind() const { return tree_->nodes_[at_].kind; }
int JsonValue::line() const { return tree_->nodes_[at_].line; }
int JsonValue::key_line() const { return tree_->nodes_[at_].key_line; }

double JsonValue::number() const {
    TEXELSCOPE_ASSERT(kind() == JsonKind::number);
    return tree_->nodes_[at_].number;
}

bool JsonValue::boolean() const {
    TEXELSCOPE_ASSERT(kind() == JsonKind::boolean);
    return tree_->nodes_[at_].number != 0;
}

std::string_view JsonValue::text() const {
    TEXELSCOPE_ASSERT(kind() == JsonKind::text);
    const JsonTree::Piece piece = tree_->nodes_[at_].text;
    return std::string_view(tree_->characters_).substr(piece.first, piece.size);
}

std::string_view JsonValue::key() const {
    const JsonTree::Piece piece = tree_->nodes_[at_].key;
    return std::string_view(tree_->characters_).substr(piece.first, piece.size);
}

JsonValue::Iterator& JsonValue::Iterator::operator++() {
    at_ = tree_->nodes_[at_].end;
    return *this;
}

JsonValue::Iterator JsonValue::end() const { return {tree_, tree_->nodes_[at_].end}; }

std::size_t JsonValue::size() const {
    std::size_t count = 0;
    for (Iterator at = begin(); at != end(); ++at) ++count;
    return count;
}

Result<JsonTree> JsonTree::parse(std::string_view text, std::string_view name, int first_line) {
    Builder builder(text, first_line);
    const Reader first(text.data(), &builder.taken), last(text.data() + text.size(), &builder.taken);
    if (!nlohmann::json::sax_parse(first, last, &builder))
        return Error{std::string(name) + ":" + std::to_string(builder.line()), builder.fault};
    JsonTree tree;
    tree.nodes_ = std::move(builder.nodes);
    tree.characters_ = std::move(builder.characters);
    for (std::uint32_t at = 0; at < tree.nodes_.size(); ++at) {
        const JsonValue value(&tree, at);
        if (value.kind() != JsonKind::object) continue;
        const JsonValue::Iterator twice = repeated_key(value);
        if (twice != value.end())
            return Error{std::string(name) + ":" + std::to_string((*twice).key_line()),
                         "key " + in_quotes((*twice).key()) + " is given twice"};
    }
    return tree;
}

}  // namespace texelscope
