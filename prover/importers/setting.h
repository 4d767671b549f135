// A variable that has another value for a while.
#pragma once

#include <utility>

namespace plprove::importers {

/// Gives a variable a value, and the one that it had when this ends.
template <class T>
class Setting {
public:
    Setting(T& variable, T value) : variable_(variable), kept_(std::exchange(variable, value)) {}
    ~Setting() { variable_ = kept_; }
    Setting(const Setting&) = delete;
    Setting& operator=(const Setting&) = delete;

private:
    T& variable_;
    T kept_;
};

} // namespace plprove::importers
