#!/bin/sh
# update.sh LUPDATE SOURCE_DIR TS_DIR: takes the sentences of the sources into TS_DIR/gorizont_ru.ts and gorizont_en.ts.
# New ones come as unfinished; translate them in linguist or in a text editor, then the test tst_translations is content.
set -eu
lupdate=$1
source=$2
ts=$3
set -- "$source/app" "$source/core" "$source/ui" -extensions cpp,h -I "$source" -locations none -no-obsolete
"$lupdate" -silent "$@" -source-language en -target-language ru -ts "$ts/gorizont_ru.ts"
"$lupdate" -silent "$@" -source-language en -target-language en -pluralonly -ts "$ts/gorizont_en.ts"
