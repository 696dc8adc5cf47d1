// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/json_tree.h"

#include "core/error.h"

#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

namespace scree {

namespace {

constexpr std::size_t max_depth = 100; // limits recursion; usual scenes have less than 10

// An iterator that counts the lines that the parser has read.
struct LineCounter {
    int line = 1;
    bool after_newline = false;
};

class CountingIterator {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, LineCounter* counter) : at_(at), counter_(counter) {}

    reference operator*() const { return *at_; }
    CountingIterator& operator++() {
        counter_->after_newline = *at_ == '\n';
        if (counter_->after_newline)
            ++counter_->line;
        ++at_;
        return *this;
    }
    friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
        return a.at_ == b.at_;
    }
    friend bool operator!=(const CountingIterator& a, const CountingIterator& b) {
        return a.at_ != b.at_;
    }

  private:
    const char* at_;
    LineCounter* counter_;
};

// Builds Json values from the parser's events.
class Builder final : public nlohmann::json_sax<nlohmann::json> {
  public:
    Builder(std::string file, const LineCounter& counter)
        : file_(std::move(file)), counter_(counter) {}

    Json root;

    bool null() override { return add(std::monostate{}); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(std::int64_t{value}); }
    bool number_unsigned(number_unsigned_t value) override {
        if (value > std::uint64_t(std::numeric_limits<std::int64_t>::max()))
            return add(static_cast<double>(value));
        return add(static_cast<std::int64_t>(value));
    }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::Object{}); }
    bool start_array(std::size_t) override { return open(Json::Array{}); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        if (!names_.back().insert(name).second)
            fail_in_json(file_, line(), "\"" + name + "\" appears twice");
        keys_.back() = std::move(name);
        return true;
    }

    bool parse_error(std::size_t, const std::string&,
                     const nlohmann::json::exception& error) override {
        // The message is "[json.exception...] parse error at line 1, column 2: syntax error while
        // ...: reason".
        std::string message = error.what();
        const std::size_t what = message.find(" - ");
        const std::size_t other = message.find(": ", message.find("column"));
        message = what != std::string::npos    ? message.substr(what + 3)
                  : other != std::string::npos ? message.substr(other + 2)
                                               : message;
        fail_in_json(file_, line(),
                     "this is not JSON: " + message.substr(0, message.find("; last read")));
    }

  private:
    int line() const { return counter_.line - (counter_.after_newline ? 1 : 0); }

    template <class T>
    bool add(T value) {
        place(Json{line(), std::move(value)});
        return true;
    }

    Json* place(Json value) {
        if (open_.empty()) {
            root = std::move(value);
            return &root;
        }
        if (auto* array = std::get_if<Json::Array>(&open_.back()->data))
            return &array->emplace_back(std::move(value));
        auto& object = std::get<Json::Object>(open_.back()->data);
        return &object.emplace_back(keys_.back(), std::move(value)).second;
    }

    template <class T>
    bool open(T container) {
        if (open_.size() == max_depth)
            fail_in_json(file_, line(),
                         fmt::format("values are nested more than {} deep", max_depth));
        open_.push_back(place(Json{line(), std::move(container)}));
        keys_.emplace_back();
        names_.emplace_back();
        return true;
    }

    bool close() {
        open_.pop_back();
        keys_.pop_back();
        names_.pop_back();
        return true;
    }

    std::string file_;
    const LineCounter& counter_;
    // A container does not grow while one of its members is open, so the pointers stay valid.
    std::vector<Json*> open_;
    std::vector<std::string> keys_;
    std::vector<std::set<std::string>> names_;
};

} // namespace

void fail_in_json(const std::string& file, int line, std::string message, std::string path) {
    throw Error(Diagnostic{{file, line}, std::move(path), std::move(message), {}});
}

Json parse_json(std::string_view text, const std::string& file) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        fail_in_json(file, 1, "this is not JSON: the file is empty"); // the library's message
                                                                      // differs between versions
    LineCounter counter;
    Builder builder(file, counter);
    const CountingIterator begin(text.data(), &counter);
    const CountingIterator end(text.data() + text.size(), &counter);
    if (!nlohmann::json::sax_parse(begin, end, &builder))
        fail_in_json(file, counter.line, "this is not JSON");
    return std::move(builder.root);
}

} // namespace scree
