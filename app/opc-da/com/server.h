#pragma once
#include "app/opc-da/com/session.h"
#include "app/opc-da/com/sink.h"
#include "app/opc-da/pure/engineering.h"

namespace opcda {

/// What a client gets by CoCreateInstance; its methods come on any thread.
class Server final : public Object<
                         IOPCServer, IOPCCommon, IOPCBrowseServerAddressSpace, IOPCItemProperties, IOPCBrowse,
                         IOPCItemIO, IConnectionPointContainer>
{
public:
    explicit Server(Gate &gate);

    // IOPCServer
    STDMETHODIMP AddGroup(
        LPCWSTR name, BOOL isActive, DWORD rate, OPCHANDLE client, LONG *timeBias, FLOAT *deadband, DWORD locale,
        OPCHANDLE *handle, DWORD *revisedRate, REFIID wanted, IUnknown **group) override;
    STDMETHODIMP GetErrorString(HRESULT code, LCID locale, LPWSTR *sentence) override;
    STDMETHODIMP GetGroupByName(LPCWSTR name, REFIID wanted, IUnknown **group) override;
    STDMETHODIMP GetStatus(OPCSERVERSTATUS **status) override;
    STDMETHODIMP RemoveGroup(OPCHANDLE handle, BOOL isForced) override;
    STDMETHODIMP CreateGroupEnumerator(OPCENUMSCOPE scope, REFIID wanted, IUnknown **enumerator) override;

    // IOPCCommon
    STDMETHODIMP SetLocaleID(LCID locale) override;
    STDMETHODIMP GetLocaleID(LCID *locale) override;
    STDMETHODIMP QueryAvailableLocaleIDs(DWORD *count, LCID **locales) override;
    STDMETHODIMP GetErrorString(HRESULT code, LPWSTR *sentence) override;
    STDMETHODIMP SetClientName(LPCWSTR name) override;

    // IOPCBrowseServerAddressSpace
    STDMETHODIMP QueryOrganization(OPCNAMESPACETYPE *organization) override;
    STDMETHODIMP ChangeBrowsePosition(OPCBROWSEDIRECTION direction, LPCWSTR name) override;
    STDMETHODIMP BrowseOPCItemIDs(
        OPCBROWSETYPE kind, LPCWSTR filter, VARTYPE type, DWORD rights, IEnumString **names) override;
    STDMETHODIMP GetItemID(LPWSTR name, LPWSTR *id) override;
    STDMETHODIMP BrowseAccessPaths(LPCWSTR id, IEnumString **paths) override;

    // IOPCItemProperties
    STDMETHODIMP QueryAvailableProperties(
        LPWSTR id, DWORD *count, DWORD **properties, LPWSTR **descriptions, VARTYPE **types) override;
    STDMETHODIMP
    GetItemProperties(LPWSTR id, DWORD count, DWORD *properties, VARIANT **values, HRESULT **errors) override;
    STDMETHODIMP LookupItemIDs(LPWSTR id, DWORD count, DWORD *properties, LPWSTR **ids, HRESULT **errors) override;

    // IOPCBrowse
    STDMETHODIMP GetProperties(
        DWORD count, LPWSTR *ids, BOOL withValues, DWORD propertyCount, DWORD *properties,
        OPCITEMPROPERTIES **found) override;
    STDMETHODIMP Browse(
        LPWSTR id, LPWSTR *continuation, DWORD most, OPCBROWSEFILTER kind, LPWSTR nameFilter, LPWSTR vendorFilter,
        BOOL allProperties, BOOL withValues, DWORD propertyCount, DWORD *properties, BOOL *isMore, DWORD *count,
        OPCBROWSEELEMENT **elements) override;

    // IOPCItemIO
    STDMETHODIMP Read(
        DWORD count, LPCWSTR *ids, DWORD *maxAges, VARIANT **values, WORD **qualities, FILETIME **times,
        HRESULT **errors) override;
    STDMETHODIMP WriteVQT(DWORD count, LPCWSTR *ids, OPCITEMVQT *values, HRESULT **errors) override;

    // IConnectionPointContainer
    STDMETHODIMP EnumConnectionPoints(IEnumConnectionPoints **points) override;
    STDMETHODIMP FindConnectionPoint(REFIID wanted, IConnectionPoint **point) override;

private:
    ~Server() override;

    template <class Work> HRESULT locked(Work work)
    {
        if (!m_session->knowsCaller())
            m_session->noteCaller();
        return m_session->gate().locked([&]() -> HRESULT { return m_session->isClosed() ? E_FAIL : work(); });
    }
    TagBook &book() const { return m_session->gate().book(); }
    /// Under the lock: the tag of this name, or why there is none.
    HRESULT findItem(const wchar_t *id, int &tag) const;
    Text browsePlace(TextView name) const;
    OPCITEMPROPERTIES propertiesOf(
        const wchar_t *id, const std::vector<DWORD> &wanted, bool isAll, bool withValues) const;

    const std::shared_ptr<Session> m_session;
    SinkPoint<IOPCShutdown> m_shutdown;
};

/// The properties of a tag, in the order of their numbers.
std::vector<DWORD> propertiesOf(const Tag &tag);
VARTYPE typeOfProperty(DWORD property, const Tag &tag);
/// OpcInvalidPid when the tag has no such property.
HRESULT propertyValue(DWORD property, const Tag &tag, const TagState &state, VARIANT *value);

} // namespace opcda
