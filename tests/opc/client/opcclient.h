#pragma once
#include "tests/opc/client/report.h"

#include <vector>

namespace opctest {

inline const std::wstring And3 = L"[COM5].Sensor_001[AND3][Addr:002]";
inline const std::wstring Ind3 = L"[COM16].Sensor_002[IND3][Addr:003]";
inline const std::wstring Net = L"[tcp://10.0.0.7:502].Sensor_003[AND3][Addr:001]";
constexpr int Bulk = 1000;

std::wstring bulkName(int number); ///< from 1

/// Freed at the end of its scope. What a method has allocated for its caller.
template <class T> class Allocated
{
public:
    Allocated() = default;
    ~Allocated() { CoTaskMemFree(m_data); }
    Allocated(const Allocated &) = delete;
    Allocated &operator=(const Allocated &) = delete;

    T **operator&() { return &m_data; }
    T *get() const { return m_data; }
    const T &operator[](std::size_t i) const { return m_data[i]; }
    explicit operator bool() const { return m_data != nullptr; }

private:
    T *m_data = nullptr;
};
using AllocatedText = Allocated<wchar_t>;

/// By ProgID, in a process of its own.
ComPtr<IOPCServer> connected(HRESULT *result = nullptr);

template <class Interface> ComPtr<Interface> as(IUnknown *object)
{
    ComPtr<Interface> found;
    if (object)
        object->QueryInterface(__uuidof(Interface), reinterpret_cast<void **>(found.GetAddressOf()));
    return found;
}

struct AddedGroup
{
    ComPtr<IOPCItemMgt> items;
    OPCHANDLE handle = 0;
    DWORD rate = 0;
    HRESULT result = E_FAIL;
};
AddedGroup addGroup(
    IOPCServer *server, const wchar_t *name, DWORD rate = 100, bool isActive = true, float deadband = 0);

OPCITEMDEF wantedItem(const std::wstring &id, OPCHANDLE client = 0, VARTYPE type = VT_EMPTY);
/// Adds items with the client handles 0, 1, …; the server handles, 0 for one that was refused.
std::vector<OPCHANDLE> addItems(
    IOPCItemMgt *group, const std::vector<std::wstring> &ids, VARTYPE type = VT_EMPTY,
    std::vector<HRESULT> *errors = nullptr);

/// What GetState tells of a group.
struct State
{
    DWORD rate = 0;
    BOOL isActive = FALSE;
    AllocatedText name;
    LONG bias = 0;
    FLOAT deadband = 0;
    DWORD locale = 0;
    OPCHANDLE client = 0;
    OPCHANDLE server = 0;

    explicit State(IOPCGroupStateMgt *group)
    {
        group->GetState(&rate, &isActive, &name, &bias, &deadband, &locale, &client, &server);
    }
};

struct ReadItem
{
    HRESULT error = E_FAIL;
    WORD quality = 0;
    OPCHANDLE client = 0;
    FILETIME time{};
    VARTYPE type = VT_EMPTY;
    double number = 0; ///< of VT_R8, VT_R4, VT_BOOL, VT_I2, VT_I4, VT_UI1
    std::wstring text; ///< of VT_BSTR
};
ReadItem readItem(const VARIANT &value);
std::vector<ReadItem> readItems(
    IOPCItemMgt *group, std::vector<OPCHANDLE> handles, OPCDATASOURCE source = OPC_DS_CACHE, HRESULT *result = nullptr);

std::vector<std::wstring> stringsOf(IEnumString *enumerator);

/// Ids of the running processes of this file name.
std::vector<DWORD> processesOf(const wchar_t *file);
void killGateways();

} // namespace opctest
