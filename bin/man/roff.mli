(** A page of the manual, for man(7). *)

val lines : Markdown.block list -> string list
(** [lines blocks] is the lines, in ASCII, of a page that says [blocks].
    Headings of level 2 are its sections, those of level 3 subsections, and
    that of level 1 is left out. Where [blocks] show a picture, the page names
    its file. Of a table, each row is its first cell at the margin, and the
    others below that; pictures are below their headers. *)
