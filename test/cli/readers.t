What raylab writes is for other programs, and these read it, each by code of its
own: ImageMagick, netpbm, GDK-Pixbuf and stb_image. They must see the pixels of
the PPM, and find nothing to say.

  $ unset DISPLAY
  $ for reader in convert bmptopnm pngtopnm gdk-pixbuf-pixdata; do
  >   command -v $reader > /dev/null || echo "$reader is missing: run bin/setup --test"
  > done
  $ cat > stb.c <<EOF
  > #define STB_IMAGE_IMPLEMENTATION
  > #include <stb/stb_image.h>
  > int main(int n, char **names) {
  >   int width, height, channels;
  >   unsigned char *rgb = stbi_load(names[1], &width, &height, &channels, 3);
  >   if (!rgb) { puts(stbi_failure_reason()); return 1; }
  >   return fwrite(rgb, 3 * width, height, stdout) != height;
  > }
  > EOF
  $ cc stb.c -o stb -lm || echo "stb_image is missing: run bin/setup --test"

GDK-Pixbuf fills rows up to four bytes, after a header of 24.

  $ gdk () {
  >   gdk-pixbuf-pixdata $1 gdk.data
  >   for y in $(seq 0 $(($3 - 1))); do
  >     tail -c +$((25 + y * ((3 * $2 + 3) / 4 * 4))) gdk.data | head -c $((3 * $2))
  >   done
  > }
  $ netpbm () {
  >   ${1##*.}topnm $1 2> err | tail -c $((3 * $2 * $3))
  >   grep warning err >&2
  > }
  $ read_by_all () {
  >   convert $1 -depth 8 rgb:- 2>&1 | cmp - pixels
  >   netpbm "$@" | cmp - pixels
  >   gdk "$@" | cmp - pixels
  >   ./stb $1 | cmp - pixels
  > }

  $ cat > mirror.scene <<EOF
  > imWidth 60   imHeight 40   canvWidth 6   canvHeight 4   depth 4
  > bcolor 0.2 0.3 0.5
  > lights
  > directional 0.9 1 0.9 0.8  1 -2 1.5
  > objects
  > plane 0 -1.5 0  0 1 0      diffusive 0.8 0.3 0.2
  > sphere 0 0 4 1.4           mixed 0.2 diffusive red 0.8 reflective
  > EOF
  $ each_size () {
  >   for size in 1x1 2x3 3x2 7x5 60x40; do
  >     width=${size%x*} height=${size#*x}
  >     raylab render mirror.scene -q --size $size -o a.ppm
  >     tail -c $((3 * width * height)) a.ppm > pixels
  >     raylab render mirror.scene -q --size $size -o a.$1 $2${2:+$((height - 1))}
  >     read_by_all a.$1 $width $height
  >   done
  > }

Whole pictures. A PNG is the plainest there is.

  $ each_size bmp
  $ each_size png
  $ pngtopnm -verbose a.png 2>&1 > /dev/null | grep interlaced
  pngtopnm: truecolor, not interlaced, base filter

Bands. Only netpbm says something, of the label of a BMP, which lies after the
pixels.

  $ each_size png --rows=0-
  $ each_size bmp --rows=0-
  bmptopnm: warning: some image data remains unread.
  bmptopnm: warning: some image data remains unread.
  bmptopnm: warning: some image data remains unread.
  bmptopnm: warning: some image data remains unread.
  bmptopnm: warning: some image data remains unread.
