// IOPCServer and IOPCCommon of the server object.
#include "app/opc-da/com/server.h"

#include "app/opc-da/com/group.h"
#include "app/opc-da/com/locale.h"

#include <cstdio>

namespace opcda {

namespace {

/// Minutes that local time lies behind UTC now: what a group gets when its client names no bias.
LONG machineTimeBias()
{
    TIME_ZONE_INFORMATION zone{};
    const DWORD season = GetTimeZoneInformation(&zone);
    return zone.Bias + (season == TIME_ZONE_ID_DAYLIGHT ? zone.DaylightBias : zone.StandardBias);
}

} // namespace

Server::Server(Gate &gate)
    : m_session(std::make_shared<Session>(gate))
    , m_shutdown(gate, this)
{
    m_session->shutdownSink = [this] { return m_shutdown.sink(); };
    m_session->serverObject = [this] { return held(); };
    gate.enter(m_session);
}

Server::~Server()
{
    m_session->close();
}

HRESULT Server::AddGroup(
    LPCWSTR name, BOOL isActive, DWORD rate, OPCHANDLE client, LONG *timeBias, FLOAT *deadband, DWORD locale,
    OPCHANDLE *handle, DWORD *revised, REFIID wanted, IUnknown **group)
{
    if (!cleared(group) || !handle || !revised || (deadband && !(*deadband >= 0 && *deadband <= 100)))
        return E_INVALIDARG;
    *handle = 0;
    m_session->noteCaller();
    GroupSettings settings;
    settings.name = textOf(name);
    settings.isActive = isActive != FALSE;
    settings.rate = *revised = revisedRate(rate);
    settings.client = client;
    settings.timeBias = timeBias ? *timeBias : machineTimeBias();
    settings.deadband = deadband ? *deadband : 0;
    settings.locale = locale;
    ComPtr<Group> added; // goes after the lock when it is not wanted
    return locked([&]() -> HRESULT {
        if (settings.name.empty())
            settings.name = m_session->freeName();
        else if (m_session->groupByName(settings.name))
            return OpcDuplicateName;
        added = made<Group>(m_session, std::move(settings));
        const HRESULT found = added->QueryInterface(wanted, reinterpret_cast<void **>(group));
        if (FAILED(found))
            return found;
        *handle = added->handle();
        m_session->groups.emplace(added->handle(), added);
        return rate == *revised ? S_OK : OpcUnsupportedRate;
    });
}

HRESULT Server::GetErrorString(HRESULT code, LCID locale, LPWSTR *sentence)
try {
    if (!cleared(sentence) || !isKnown(locale))
        return E_INVALIDARG;
    const Text text = sentenceFor(code, locale);
    if (text.empty())
        return E_INVALIDARG;
    *sentence = taskText(text);
    return S_OK;
} catch (const std::bad_alloc &) {
    return E_OUTOFMEMORY;
}

HRESULT Server::GetGroupByName(LPCWSTR name, REFIID wanted, IUnknown **group)
{
    if (!cleared(group))
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        Group *found = m_session->groupByName(textOf(name));
        return found ? found->QueryInterface(wanted, reinterpret_cast<void **>(group)) : E_INVALIDARG;
    });
}

HRESULT Server::GetStatus(OPCSERVERSTATUS **status)
{
    if (!cleared(status))
        return E_INVALIDARG;
    m_session->noteCaller();
    return locked([&]() -> HRESULT {
        TaskArray<OPCSERVERSTATUS> answer(1);
        unsigned major = 0;
        unsigned minor = 0;
        unsigned build = 0;
        std::sscanf(GORIZONT_VERSION, "%u.%u.%u", &major, &minor, &build);
        answer[0].ftStartTime = m_session->gate().startTime();
        answer[0].ftCurrentTime = fileTime(unixMilliseconds());
        answer[0].ftLastUpdateTime = m_session->lastUpdate;
        answer[0].dwServerState = OPC_STATUS_RUNNING; // what cannot be known of a tag is told by its quality
        answer[0].dwGroupCount = static_cast<DWORD>(m_session->groups.size());
        answer[0].dwBandWidth = 0xFFFFFFFF; // not known
        answer[0].wMajorVersion = static_cast<WORD>(major);
        answer[0].wMinorVersion = static_cast<WORD>(minor);
        answer[0].wBuildNumber = static_cast<WORD>(build);
        answer[0].szVendorInfo = taskText(u"Gorizont Server " + fromUtf8(book().version()));
        answer.giveTo(status);
        return S_OK;
    });
}

HRESULT Server::RemoveGroup(OPCHANDLE handle, BOOL isForced)
{
    // Released after the lock: the last references to objects of the client's process are among them.
    ComPtr<Group> removed;
    ComPtr<IOPCDataCallback> sink;
    return locked([&]() -> HRESULT {
        const auto found = m_session->groups.find(handle);
        if (found == m_session->groups.end())
            return OpcInvalidHandle;
        removed = found->second;
        m_session->groups.erase(found);
        const bool isInUse = removed->isHeld();
        sink = removed->remove();
        return isInUse && !isForced ? OpcInUse : S_OK;
    });
}

HRESULT Server::CreateGroupEnumerator(OPCENUMSCOPE scope, REFIID wanted, IUnknown **enumerator)
{
    if (!cleared(enumerator) || scope < OPC_ENUM_PRIVATE_CONNECTIONS || scope > OPC_ENUM_ALL)
        return E_INVALIDARG;
    // All groups are private; there are no public ones.
    const bool isWanted = scope != OPC_ENUM_PUBLIC && scope != OPC_ENUM_PUBLIC_CONNECTIONS;
    ComPtr<IUnknown> list;
    bool isEmpty = true;
    const HRESULT result = locked([&]() -> HRESULT {
        std::vector<Text> names;
        std::vector<ComPtr<IUnknown>> groups;
        for (const auto &[handle, group] : m_session->groups) {
            if (!isWanted)
                break;
            names.push_back(group->name());
            groups.emplace_back(static_cast<IOPCItemMgt *>(group.Get()));
        }
        isEmpty = names.empty();
        if (IsEqualIID(wanted, __uuidof(IEnumString)))
            list = made<StringEnumerator>(std::move(names));
        else if (IsEqualIID(wanted, __uuidof(IEnumUnknown)) || IsEqualIID(wanted, __uuidof(IUnknown)))
            list = made<UnknownEnumerator>(std::move(groups));
        return list ? S_OK : E_NOINTERFACE;
    });
    if (FAILED(result))
        return result;
    const HRESULT found = list->QueryInterface(wanted, reinterpret_cast<void **>(enumerator));
    return FAILED(found) ? found : isEmpty ? S_FALSE : S_OK;
}

HRESULT Server::SetLocaleID(LCID locale)
{
    if (!isKnown(locale))
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        m_session->locale = locale;
        return S_OK;
    });
}

HRESULT Server::GetLocaleID(LCID *locale)
{
    if (!locale)
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        *locale = m_session->locale;
        return S_OK;
    });
}

HRESULT Server::QueryAvailableLocaleIDs(DWORD *count, LCID **locales)
try {
    if (!cleared(locales) || !count)
        return E_INVALIDARG;
    TaskArray<LCID> offered(OfferedLocales.size());
    for (std::size_t i = 0; i < OfferedLocales.size(); ++i)
        offered[i] = OfferedLocales[i];
    offered.giveTo(locales);
    *count = static_cast<DWORD>(OfferedLocales.size());
    return S_OK;
} catch (const std::bad_alloc &) {
    return E_OUTOFMEMORY;
}

HRESULT Server::GetErrorString(HRESULT code, LPWSTR *sentence)
{
    LCID locale = 0;
    const HRESULT known = GetLocaleID(&locale);
    return FAILED(known) ? (cleared(sentence), known) : GetErrorString(code, locale, sentence);
}

HRESULT Server::SetClientName(LPCWSTR)
{
    m_session->noteCaller();
    return S_OK; // nobody here looks at the names of clients
}

HRESULT Server::EnumConnectionPoints(IEnumConnectionPoints **points)
{
    if (!cleared(points))
        return E_POINTER;
    return m_session->gate().locked([&]() -> HRESULT {
        *points = made<PointEnumerator>(std::vector{ComPtr<IConnectionPoint>(&m_shutdown)}).Detach();
        return S_OK;
    });
}

HRESULT Server::FindConnectionPoint(REFIID wanted, IConnectionPoint **point)
{
    if (!cleared(point))
        return E_POINTER;
    if (!IsEqualIID(wanted, __uuidof(IOPCShutdown)))
        return CONNECT_E_NOCONNECTION;
    return m_shutdown.QueryInterface(__uuidof(IConnectionPoint), reinterpret_cast<void **>(point));
}

} // namespace opcda
