#include "prover/estimator/sampler.h"

#include "prover/three_views/random.h"

#include <algorithm>
#include <iterator>

namespace plprove {

namespace {

template <class Match>
bool seen_by(const Match& match, ViewSet views) {
    for (std::size_t v = 0; v < match.size(); ++v)
        if (contains(views, static_cast<int>(v)) && !match[v]) return false;
    return true;
}

ViewSet views_of_point(const Feature& feature) {
    ViewSet views = 0;
    for (int v = 0; v < feature.views(); ++v)
        if (feature.sees_point(v)) views |= ViewSet{1} << v;
    return views;
}

/// Whether the lines through the point are enough for those of the feature.
bool has_lines(const Feature& feature, const Matches& matches, std::size_t point) {
    const auto& through = matches.lines_through[point];
    for (int line = 0; line < feature.lines; ++line) {
        // Lines that are seen where this one is: as many as pins that ask for as much.
        const ViewSet wanted = views_of(feature, line);
        int pins = 0;
        for (int other = 0; other < feature.lines; ++other)
            pins += (views_of(feature, other) & wanted) == wanted;
        const auto fit = std::ranges::count_if(
            through, [&](std::size_t l) { return seen_by(matches.lines[l], wanted); });
        if (fit < pins) return false;
    }
    return true;
}

std::vector<std::size_t> matches_for(const Feature& feature, const Matches& matches) {
    std::vector<std::size_t> result;
    if (feature.has_point) {
        const ViewSet views = views_of_point(feature);
        for (std::size_t p = 0; p < matches.points.size(); ++p)
            if (seen_by(matches.points[p], views) && has_lines(feature, matches, p))
                result.push_back(p);
    } else {
        const ViewSet views = views_of(feature, 0);
        for (std::size_t l = 0; l < matches.lines.size(); ++l)
            if (seen_by(matches.lines[l], views)) result.push_back(l);
    }
    return result;
}

/// A sample on its way. Features are different matches, and no line passes through the point of
/// another feature.
class Drawing {
public:
    Drawing(const Matches& matches, Random& random, std::size_t features)
        : matches_(matches), random_(random), sample_(features) {}

    /// Nothing where no match is left for the feature.
    bool draw_point(const Feature& feature, std::size_t index,
                    const std::vector<std::size_t>& pool) {
        const auto point = one_of(pool, [&](std::size_t p) {
            return !contains(points_, p) && std::ranges::none_of(lines_, [&](std::size_t l) {
                return passes_through(l, p);
            });
        });
        if (!point) return false;
        for (int line = 0; line < feature.lines; ++line) {
            const auto drawn = one_of(matches_.lines_through[*point], [&](std::size_t l) {
                return seen_by(matches_.lines[l], views_of(feature, line)) && is_free(l);
            });
            if (!drawn) return false;
            add_line(index, *drawn);
        }
        points_.push_back(*point);
        sample_[index].point = *point;
        return true;
    }

    bool draw_line(std::size_t index, const std::vector<std::size_t>& pool) {
        const auto line = one_of(pool, [&](std::size_t l) { return is_free(l); });
        if (line) add_line(index, *line);
        return line.has_value();
    }

    const Sample& sample() const { return sample_; }

private:
    template <class Fits>
    std::optional<std::size_t> one_of(const std::vector<std::size_t>& pool, Fits fits) {
        std::vector<std::size_t> left;
        std::ranges::copy_if(pool, std::back_inserter(left), fits);
        if (left.empty()) return std::nullopt;
        return left[static_cast<std::size_t>(random_.bits() % left.size())];
    }

    static bool contains(const std::vector<std::size_t>& numbers, std::size_t number) {
        return std::ranges::find(numbers, number) != numbers.end();
    }

    bool passes_through(std::size_t line, std::size_t point) const {
        return std::ranges::binary_search(matches_.lines_through[point], line);
    }

    /// No feature has the line, and it passes through the point of none.
    bool is_free(std::size_t line) const {
        return !contains(lines_, line) && std::ranges::none_of(points_, [&](std::size_t p) {
            return passes_through(line, p);
        });
    }

    void add_line(std::size_t index, std::size_t line) {
        lines_.push_back(line);
        sample_[index].lines.push_back(line);
    }

    const Matches& matches_;
    Random& random_;
    Sample sample_;
    std::vector<std::size_t> points_, lines_; ///< of the features so far
};

} // namespace

Sampler::Sampler(const Features& problem, const Matches& matches)
    : problem_(problem), matches_(matches) {
    for (std::size_t f = 0; f < problem.size(); ++f) {
        const auto alike = std::ranges::find_if(
            pools_, [&](const Pool& pool) { return problem[pool.features[0]] == problem[f]; });
        if (alike != pools_.end())
            alike->features.push_back(f);
        else
            pools_.push_back({{f}, matches_for(problem[f], matches)});
    }
    std::ranges::stable_sort(pools_, {}, [](const Pool& pool) { return pool.matches.size(); });
}

const std::vector<std::size_t>& Sampler::candidates(std::size_t feature) const {
    const auto has_it = [&](const Pool& pool) {
        return std::ranges::find(pool.features, feature) != pool.features.end();
    };
    return std::ranges::find_if(pools_, has_it)->matches;
}

std::optional<Sample> Sampler::draw(std::uint64_t seed, std::uint64_t number) const {
    Random random(seed, number);
    constexpr int most_tries = 100;
    for (int attempt = 0; attempt < most_tries; ++attempt) {
        Drawing drawing(matches_, random, problem_.size());
        const bool whole = std::ranges::all_of(pools_, [&](const Pool& pool) {
            return std::ranges::all_of(pool.features, [&](std::size_t f) {
                return problem_[f].has_point ? drawing.draw_point(problem_[f], f, pool.matches)
                                             : drawing.draw_line(f, pool.matches);
            });
        });
        if (whole) return drawing.sample();
    }
    return std::nullopt;
}

} // namespace plprove
