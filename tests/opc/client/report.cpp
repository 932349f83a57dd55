#include "tests/opc/client/report.h"

#include <cstdio>

namespace opctest {

namespace {
int failed = 0;

std::string hex(HRESULT code)
{
    char text[16];
    std::snprintf(text, sizeof(text), "%08lX", static_cast<unsigned long>(code));
    return text;
}

void say(const std::string &line)
{
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
}
} // namespace

void check(const std::string &name, bool isWell, const std::string &why)
{
    failed += isWell ? 0 : 1;
    say((isWell ? "ok " : "FAIL ") + name + (isWell || why.empty() ? "" : ": " + why));
}

void checkResult(const std::string &name, HRESULT wanted, HRESULT got)
{
    check(name, wanted == got, "wanted " + hex(wanted) + ", got " + hex(got));
}

void checkText(const std::string &name, const std::wstring &wanted, const wchar_t *got)
{
    check(name, got && wanted == got, got ? "got «" + toUtf8(textOf(got)) + "»" : "no text");
}

void checkNumber(const std::string &name, double wanted, double got)
{
    check(name, wanted == got, "wanted " + std::to_string(wanted) + ", got " + std::to_string(got));
}

void ask(const std::string &what)
{
    say("do " + what);
}

void note(const std::string &what)
{
    say("note " + what);
}

int failures()
{
    return failed;
}

} // namespace opctest
