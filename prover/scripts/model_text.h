// Writing the text of a model (docs/models.md).
#pragma once

#include <string>

namespace plprove {

class ModelText {
public:
    void comment(const std::string& text);
    /// A line, indented as deep as loops are open; a comment behind it may say what it is.
    void line(const std::string& statement, const std::string& remark = "");
    void begin_loop(const std::string& name, const std::string& bounds);
    void end_loop();

    const std::string& text() const { return text_; }

private:
    std::string text_;
    std::size_t depth_ = 0;
};

/// What is written for cameras and for features; a text between brackets if it is a sum.
std::string in_brackets(const std::string& sum);

} // namespace plprove
