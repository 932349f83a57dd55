#pragma once

namespace opctest {

// Each is one word of the command line; a test without a gateway of its own runs against the values of fake_feed.py.
void testRegistry(); ///< categories, ProgID
void testServer(); ///< IOPCServer, IOPCCommon, groups, enumerators
void testBrowsing(); ///< IOPCBrowseServerAddressSpace, IOPCBrowse, properties, IOPCItemIO
void testItems(); ///< IOPCItemMgt, types, deadbands
void testReading(); ///< IOPCSyncIO, IOPCSyncIO2
void testCallbacks(); ///< IOPCAsyncIO2, IOPCAsyncIO3, subscription
void testState(); ///< IOPCGroupStateMgt, IOPCGroupStateMgt2, CloneGroup
void testThousand(); ///< 1000 items under load
void testOutage(); ///< the feed goes and comes back
void testDeath(); ///< the gateway dies under its client
void testShutdown(); ///< the main program ends
void testHold(); ///< subscribes and waits for its own death
void testSurvivor(); ///< after the death of another client
void testEnding(); ///< the gateway ends after its last client
void testChain(); ///< the whole chain with the simulator
void testListAlone(); ///< the program does not run, its list of tags was registered
void runBench();

} // namespace opctest
