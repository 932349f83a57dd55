// IOPCItemProperties and IOPCBrowse of the server object.
#include "app/opc-da/com/locale.h"
#include "app/opc-da/com/server.h"

#include <charconv>

namespace opcda {

HRESULT Server::QueryAvailableProperties(
    LPWSTR id, DWORD *count, DWORD **properties, LPWSTR **descriptions, VARTYPE **types)
{
    if (!count || !cleared(properties) || !cleared(descriptions) || !cleared(types))
        return E_INVALIDARG;
    *count = 0;
    return locked([&]() -> HRESULT {
        int index = 0;
        if (const HRESULT found = findItem(id, index); FAILED(found))
            return found;
        const Tag &tag = book().names().at(index);
        const std::vector<DWORD> known = opcda::propertiesOf(tag);
        TaskArray<DWORD> numbers(known.size());
        TaskArray<LPWSTR> names(known.size());
        TaskArray<VARTYPE> variantTypes(known.size());
        for (std::size_t i = 0; i < known.size(); ++i) {
            numbers[i] = known[i];
            names[i] = taskText(propertyName(known[i], languageOf(m_session->locale)));
            variantTypes[i] = typeOfProperty(known[i], tag);
        }
        numbers.giveTo(properties);
        names.giveTo(descriptions);
        variantTypes.giveTo(types);
        *count = static_cast<DWORD>(known.size());
        return S_OK;
    });
}

HRESULT Server::GetItemProperties(LPWSTR id, DWORD count, DWORD *properties, VARIANT **values, HRESULT **errors)
{
    if (!cleared(values) || !cleared(errors) || !properties || count == 0)
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        int index = 0;
        if (const HRESULT found = findItem(id, index); FAILED(found))
            return found;
        TaskArray<VARIANT> data(count);
        TaskArray<HRESULT> codes(count);
        bool isAllWell = true;
        for (DWORD i = 0; i < count; ++i) {
            codes[i] = propertyValue(properties[i], book().names().at(index), book().state(index), &data[i]);
            isAllWell = isAllWell && codes[i] == S_OK;
        }
        data.giveTo(values);
        codes.giveTo(errors);
        return isAllWell ? S_OK : S_FALSE;
    });
}

HRESULT Server::LookupItemIDs(LPWSTR id, DWORD count, DWORD *properties, LPWSTR **ids, HRESULT **errors)
{
    if (!cleared(ids) || !cleared(errors) || !properties || count == 0)
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        int index = 0;
        if (const HRESULT found = findItem(id, index); FAILED(found))
            return found;
        const std::vector<DWORD> known = opcda::propertiesOf(book().names().at(index));
        TaskArray<LPWSTR> names(count);
        TaskArray<HRESULT> codes(count);
        for (DWORD i = 0; i < count; ++i) {
            // No property is an item of its own here; 1…6 never are.
            const bool isKnown =
                properties[i] > 6 && std::find(known.begin(), known.end(), properties[i]) != known.end();
            codes[i] = isKnown ? E_FAIL : OpcInvalidPid;
        }
        names.giveTo(ids);
        codes.giveTo(errors);
        return S_FALSE;
    });
}

OPCITEMPROPERTIES
Server::propertiesOf(const wchar_t *id, const std::vector<DWORD> &wanted, bool isAll, bool withValues) const
{
    OPCITEMPROPERTIES answer{};
    int index = 0;
    answer.hrErrorID = findItem(id, index);
    if (FAILED(answer.hrErrorID))
        return answer;
    const Tag &tag = book().names().at(index);
    const std::vector<DWORD> numbers = isAll ? opcda::propertiesOf(tag) : wanted;
    TaskArray<OPCITEMPROPERTY> properties(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        OPCITEMPROPERTY &property = properties[i];
        property.dwPropertyID = numbers[i];
        property.vtDataType = typeOfProperty(numbers[i], tag);
        property.szItemID = taskText({});
        property.szDescription = taskText(propertyName(numbers[i], languageOf(m_session->locale)));
        VARIANT value;
        property.hrErrorID = propertyValue(numbers[i], tag, book().state(index), &value);
        if (withValues)
            property.vValue = value;
        else
            VariantClear(&value);
        if (FAILED(property.hrErrorID))
            answer.hrErrorID = S_FALSE;
    }
    properties.giveTo(&answer.pItemProperties);
    answer.dwNumProperties = static_cast<DWORD>(numbers.size());
    return answer;
}

HRESULT Server::GetProperties(
    DWORD count, LPWSTR *ids, BOOL withValues, DWORD propertyCount, DWORD *properties, OPCITEMPROPERTIES **found)
{
    if (!cleared(found) || !ids || count == 0 || (propertyCount > 0 && !properties))
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        const std::vector<DWORD> wanted(properties, properties + propertyCount);
        TaskArray<OPCITEMPROPERTIES> answers(count);
        bool isAllWell = true;
        for (DWORD i = 0; i < count; ++i) {
            answers[i] = propertiesOf(ids[i], wanted, wanted.empty(), withValues != FALSE);
            isAllWell = isAllWell && answers[i].hrErrorID == S_OK;
        }
        answers.giveTo(found);
        return isAllWell ? S_OK : S_FALSE;
    });
}

namespace {

/// A continuation point is the number of elements that were given before. False when the text is none.
bool readPosition(const Text &continuation, std::size_t most, std::size_t &position)
{
    if (continuation.empty())
        return true;
    const std::string digits = toUtf8(continuation);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), position);
    return error == std::errc() && end == digits.data() + digits.size() && position > 0 && position < most;
}

struct Element
{
    Text name;
    DWORD flags; ///< 1 has children, 2 is an item
};

constexpr DWORD HasChildren = 1;
constexpr DWORD IsItem = 2;

std::vector<Element> elementsOf(const AddressSpace::Branch &branch, OPCBROWSEFILTER kind, const Text &pattern)
{
    std::vector<Element> elements;
    for (const Text &name : branch.branches) {
        if (kind != OPC_BROWSE_FILTER_ITEMS && matches(pattern, name))
            elements.push_back({name, HasChildren});
    }
    for (const auto &leaf : branch.leaves) {
        if (kind != OPC_BROWSE_FILTER_BRANCHES && matches(pattern, leaf.first))
            elements.push_back({leaf.first, IsItem});
    }
    return elements;
}

} // namespace

HRESULT Server::Browse(
    LPWSTR id, LPWSTR *continuation, DWORD most, OPCBROWSEFILTER kind, LPWSTR nameFilter, LPWSTR, BOOL allProperties,
    BOOL withValues, DWORD propertyCount, DWORD *properties, BOOL *isMore, DWORD *count, OPCBROWSEELEMENT **elements)
{
    if (!continuation || !isMore || !count || !cleared(elements) || kind < OPC_BROWSE_FILTER_ALL
        || kind > OPC_BROWSE_FILTER_ITEMS || (propertyCount > 0 && !properties))
        return E_INVALIDARG;
    *isMore = FALSE;
    *count = 0;
    return locked([&]() -> HRESULT {
        const Text place = textOf(id);
        const AddressSpace::Branch *branch = book().names().branch(place);
        if (!branch)
            return isWellFormed(place) ? OpcUnknownItemId : OpcInvalidItemId;
        const std::vector<Element> found = elementsOf(*branch, kind, textOf(nameFilter));
        std::size_t first = 0;
        if (!readPosition(textOf(*continuation), found.size(), first))
            return OpcInvalidContinuationPoint;
        const std::size_t given = most == 0 ? found.size() - first : std::min<std::size_t>(most, found.size() - first);
        const std::vector<DWORD> wanted(properties, properties + propertyCount);
        TaskArray<OPCBROWSEELEMENT> list(given);
        for (std::size_t i = 0; i < given; ++i) {
            const Element &element = found[first + i];
            const Text whole = joined(place, element.name);
            list[i].szName = taskText(element.name);
            list[i].szItemID = taskText(whole);
            list[i].dwFlagValue = element.flags;
            if ((element.flags & IsItem) && (allProperties || !wanted.empty()))
                list[i].ItemProperties =
                    propertiesOf(wide(whole).c_str(), wanted, allProperties != FALSE, withValues != FALSE);
        }
        const std::size_t end = first + given;
        const std::string next = end < found.size() ? std::to_string(end) : std::string();
        CoTaskMemFree(*continuation);
        *continuation = taskText(Text(next.begin(), next.end()));
        list.giveTo(elements);
        *count = static_cast<DWORD>(given);
        return S_OK;
    });
}

} // namespace opcda
