Whatever a file is called and whatever bytes a command line has, what is printed
about it holds none of the characters that control a terminal. Here they would
turn it red.

  $ unset DISPLAY
  $ esc=$(printf 'a\033[31mb\302\233c\342\200\256\377')
  $ cat > "$esc.scene" <<EOF
  > imWidth 2   imHeight 2   canvWidth 2   canvHeight 2   depth 1
  > EOF
  $ printf 'imWidth \033[31m\302\233 \007' > "bad$esc"

U+FFFD, which stands for them, and the dots of the usage are all that is not
ASCII.

  $ say () { raylab "$@" 2>&1 > /dev/null | sed 's/\xef\xbf\xbd/?/g; s/\xe2\x80\xa6/.../g' > said
  >   LC_ALL=C grep -c '[^ -~]' said > count; tr -d '\n' < count; echo ": $(head -n 1 said)"; }
  $ say render "$esc.scene"
  0: a?[31mb?c??.scene: warning: there is no object: the picture is all background
  $ say check "$esc.scene"
  0: a?[31mb?c??.scene: warning: there is no object: the picture is all background
  $ say check "bad$esc"
  0: bada?[31mb?c??:1:9: error: U+001B, a control character, is not seen, and belongs to no word
  $ say check "missing$esc"
  0: missinga?[31mb?c??: error: No such file or directory
  $ say render "$esc.scene" -o "./$esc.scene"
  0: raylab: ./a?[31mb?c??.scene is the scene; the picture would replace it
  $ say render "$esc.scene" -o "a.$esc"
  0: raylab: a.a?[31mb?c??: there is no picture format '.a?[31mb?c??'; use .bmp, .png or .ppm
  $ say render "$esc.scene" -o "missing/$esc.bmp"
  0: raylab: missing/a?[31mb?c??.bmp: No such file or directory
  $ say render "$esc.scene" --size "$esc" | cut -c -45
  0: raylab: option '--size': 'a?[31mb?c??' is 
  $ say render "$esc.scene" "--$esc" | cut -c -60
  0: raylab: unknown option '--a?[31mb?c??'.
  $ say "$esc" | cut -c -42
  0: raylab: unknown command 'a?[31mb?c??', 
  $ say render x y "$esc"
  0: raylab: too many arguments, don't know what to do with 'y', 'a?[31mb?c??'
