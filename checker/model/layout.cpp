#include "checker/model/layout.h"

namespace checker {
namespace {
/// A ring for models whose elements have no value: for the shapes alone.
struct Shapes {
    struct Element {};
    std::uint64_t operations = 0;

    Element constant(int) { return count(); }
    Element add(Element, Element) { return count(); }
    Element multiply(Element, Element) { return count(); }
    Element inverse(Element) { return count(); }

private:
    Element count() {
        if (++operations > 5'000'000) throw Senseless{"more than 5,000,000 operations"};
        return {};
    }
};
} // namespace

static std::size_t size_of(const std::vector<std::size_t>& shape, std::size_t most) {
    std::size_t size = 1;
    for (const std::size_t length : shape)
        if ((size *= length) > most) return most + 1;
    return size;
}

static void declare(Declared& declared, const Statement& statement, std::size_t most) {
    const std::size_t size = size_of(statement.shape, most);
    declared.names.emplace_back(statement.name, size);
    declared.scalars += size;
    if (declared.scalars > most)
        throw Malformed{{statement.line, say("a model has at most ", most, " of these scalars")}};
}

Layout layout_of(const Program& program) {
    Layout layout;
    Given<Shapes> given;
    for (const Statement& statement : program.statements) {
        if (statement.kind == Statement::Kind::data) declare(layout.data, statement, 1000);
        if (statement.kind == Statement::Kind::unknown) declare(layout.unknowns, statement, 100);
    }
    for (const Declared* declared : {&layout.data, &layout.unknowns})
        for (const auto& [name, size] : declared->names)
            given[name].resize(size);
    Shapes shapes;
    Machine<Shapes> machine(shapes, given);
    const Outcome<Shapes> outcome = machine.run(program);
    layout.equations = outcome.equations.size();
    layout.relations = outcome.relations.size();
    layout.counted = outcome.counted.size();
    layout.multiplications = shapes.operations;
    layout.values = machine.sizes();
    const std::size_t line = program.statements.back().line;
    if (layout.unknowns.scalars == 0) throw Malformed{{line, "the model has no unknown"}};
    if (layout.equations > 1000) throw Malformed{{line, "the model has more than 1,000 equations"}};
    return layout;
}
} // namespace checker
