(** [transcript RAYLAB SCENE PAGE] prints the Markdown file [PAGE] as it should
    be: it types what its blocks of [ocaml] have after the prompt
    ["raylab # "], up to [;;], all in one session of [RAYLAB repl SCENE], and
    puts what is answered below. *)
