// plprove show as its users run it.
#include "tests/support/programs.h"

TEST_CASE("a problem is drawn in the terminal and as a picture") {
    CHECK(contains(run(plprove + " show 2394").out, "view 3"));
    CHECK(run(plprove + " show 2394 --svg -").out.starts_with("<?xml"));
}

TEST_CASE("one run writes the picture for a page and for LaTeX") {
    const TemporaryFolder folder;
    const std::string svg = (folder / "a.svg").string();
    const std::string tikz = (folder / "a.tex").string();
    const Outcome outcome = run(plprove + " show Chicago --svg " + svg + " --tikz " + tikz);
    CHECK(outcome.status == 0);
    CHECK(outcome.out.empty());
    CHECK(read_file(svg) == run(plprove + " show 2394 --svg -").out);
    CHECK(read_file(tikz) == run(plprove + " show 2394 --tikz -").out);
    CHECK(contains(read_file(tikz), "\\begin{tikzpicture}"));
}

TEST_CASE("five points are red on request, where two views share them") {
    const std::string show = plprove + " show ";
    const std::string red = " --highlight five-point";
    CHECK(contains(run(show + "P3P+five-point --svg -" + red).out, "#d00"));
    CHECK(!contains(run(show + "P3P+five-point --svg -").out, "#d00"));
    CHECK(contains(run(show + "five-point --tikz -" + red).out, "\\path[five point"));
    const Outcome none = run(show + "Chicago --svg -" + red);
    CHECK(none.status == 2);
    CHECK(none.out.empty());
    CHECK(contains(none.err, "leave --highlight out"));
    CHECK(contains(run(show + "five-point" + red).err, "add --svg FILE or --tikz FILE"));
    CHECK(run(show + "five-point --svg - --highlight P3P").status == 3);
}

TEST_CASE("LaTeX accepts what --tikz writes") {
    if (run("command -v pdflatex && kpsewhich tikz.sty").status != 0) {
        MESSAGE("there is no pdflatex with TikZ here: not tested");
        return;
    }
    const TemporaryFolder folder;
    const std::string in_folder = "cd " + folder.path().string() + " && ";
    const std::string problem = "5*P/P/a + Pabcdefghijklm/Pabcdefghijklm/- + a/a/a + b/Pab/a";
    CHECK(run(in_folder + plprove + " show '" + problem + "' --tikz a.tex").status == 0);
    CHECK(
        run(in_folder + plprove + " show five-point --highlight five-point --tikz b.tex").status ==
        0);
    write_file(folder / "page.tex", "\\documentclass{article}\n\\usepackage{tikz}\n"
                                    "\\begin{document}\n"
                                    "\\noindent\\resizebox{\\linewidth}{!}{\\input{a.tex}}\n\n"
                                    "\\noindent\\input{b.tex}\n\\end{document}\n");
    const Outcome latex = run(in_folder + "pdflatex -interaction=nonstopmode -halt-on-error page");
    CHECK_MESSAGE(latex.status == 0, latex.out);
    CHECK(!contains(latex.out, "Overfull"));
    CHECK(std::filesystem::file_size(folder / "page.pdf") > 10'000);
}
