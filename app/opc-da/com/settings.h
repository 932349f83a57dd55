#pragma once
#include "app/opc-da/pure/addressspace.h"

#include <chrono>

namespace opcda {

/// How the gateway finds the main program. Read from the key `Settings` of its class in the registry, then from the section
/// [OPC] of gorizont-opc-da.ini beside the program, which wins.
struct Settings
{
    unsigned short port = 43212; ///< Port, of the main program's feed on 127.0.0.1
    std::string hash; ///< Hash, of the tag list that was registered; empty: none
    std::wstring tagsFile; ///< Tags, a file of feed lines with that list; empty: none
    std::chrono::seconds linger{10}; ///< Linger, how long the program stays after its last client
};

Settings readSettings();

/// The tags of a file of feed lines; what cannot be read is passed over.
std::vector<Tag> tagsOf(const std::wstring &file);

/// Full path of this program.
std::wstring programPath();
/// A file in the folder of this program.
std::wstring besideProgram(const wchar_t *name);

} // namespace opcda
