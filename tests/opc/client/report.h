#pragma once
#include "app/opc-da/com/windowstext.h"

#include <string>

namespace opctest {

using namespace opcda;

/// Says `ok name` or `FAIL name why`.
void check(const std::string &name, bool isWell, const std::string &why = "");
void checkResult(const std::string &name, HRESULT wanted, HRESULT got);
void checkText(const std::string &name, const std::wstring &wanted, const wchar_t *got);
void checkNumber(const std::string &name, double wanted, double got);

/// Says what the one who runs this program is to do now: `do …`.
void ask(const std::string &what);
/// A figure to be read by people: `note …`.
void note(const std::string &what);
int failures();

/// Waits for a condition, looking every 10 ms; false when `seconds` have passed.
template <class Condition> bool happens(Condition condition, int seconds = 20)
{
    for (const ULONGLONG end = GetTickCount64() + 1000ull * static_cast<unsigned>(seconds); GetTickCount64() < end;
         Sleep(10)) {
        if (condition())
            return true;
    }
    return condition();
}

} // namespace opctest
