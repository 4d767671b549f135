#include "checker/command/progress.h"

#include <iomanip>
#include <iostream>

namespace checker {
void ProgressBar::begin(std::string_view bytes) {
    clear();
    bytes_left_ -= std::min<std::uintmax_t>(bytes_left_, bytes_);
    bytes_ = bytes.size();
    lines_ = static_cast<std::size_t>(std::ranges::count(bytes, '\n'));
    start_ = last_ = Clock::now();
}

std::string ProgressBar::time_left(double bytes_done) const {
    const std::chrono::duration<double> elapsed = last_ - start_;
    const double rest = std::max(0.0, static_cast<double>(bytes_left_) - bytes_done);
    const auto seconds = static_cast<long>(rest * elapsed.count() / bytes_done);
    std::ostringstream text;
    text << seconds / 60 << ':' << std::setfill('0') << std::setw(2) << seconds % 60;
    return text.str();
}

void ProgressBar::update(const Progress& progress) {
    constexpr std::chrono::milliseconds interval{200};
    constexpr std::size_t width = 24;
    if (!shown_ || lines_ == 0 || Clock::now() - last_ < interval) return;
    last_ = Clock::now();
    const double done = static_cast<double>(progress.line) / static_cast<double>(lines_);
    const auto filled = std::min(width, static_cast<std::size_t>(done * width));
    const double bytes_done = std::max(1.0, done * static_cast<double>(bytes_));
    std::cerr << "\r\x1b[K[" << std::string(filled, '#') << std::string(width - filled, '.') << "] "
              << progress.records << " records, " << progress.solutions << " solutions, "
              << time_left(bytes_done) << " left" << std::flush;
    drawn_ = true;
}

void ProgressBar::clear() {
    if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
    drawn_ = false;
}
} // namespace checker
