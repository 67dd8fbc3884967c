(* Files that may be written to, and cannot be replaced. To make some takes the
   rights of root, or a system that lets everybody have mounts of their own;
   elsewhere these tests are skipped, and alcotest says so. *)

open Test_support

let is_root = Unix.getuid () = 0
let sh command = Sys.command (command ^ " 2> /dev/null") = 0

let output command =
  let channel = Unix.open_process_in command in
  let text = In_channel.input_all channel in
  match Unix.close_process_in channel with
  | WEXITED 0 -> text
  | _ -> Alcotest.failf "this has failed: %s" command

(* [check folder command] has [command] write folder/file, which cannot be
   replaced for this [reason]. *)
let check folder ~reason command =
  let file = Filename.concat folder "file" in
  let inode () = (Unix.stat file).st_ino in
  let before = inode () in
  let said = output command in
  Expect.contains "what it costs" ~part:("replaced (" ^ reason ^ ")") said;
  Expect.contains "what it costs"
    ~part:"neither the older nor the new one would be whole" said;
  Alcotest.(check string) "written" "new" (Sample.read file);
  Alcotest.(check int) "it is the same file" before (inode ())

(* {1 A folder like /tmp}

   There only the owner can replace a file. *)

let test_sticky folder =
  if not is_root then Alcotest.skip ();
  Unix.chmod folder 0o1777;
  let file = Filename.concat folder "file"
  and save = Filename.concat folder "save" in
  Sample.write file "an older one";
  Unix.chmod file 0o666;
  Sample.write save (Sample.read "save.exe");
  Unix.chmod save 0o755;
  check folder ~reason:"Operation not permitted"
    (Filename.quote_command "setpriv"
       [ "--reuid=65534"; "--regid=65534"; "--clear-groups"; save; file ]);
  Alcotest.(check (list string))
    "nothing else" [ "file"; "save" ] (Sample.files folder)

(* {1 A mount point} *)

(* [mounted folder mount] is the folder's file, the place inside it where the
   commands [mount] make it appear, as "$2", and the command that then saves
   there. *)
let mounted folder mount =
  let inside = Filename.concat folder "inside" in
  let file = Filename.concat folder "file"
  and place = Filename.concat inside "place" in
  Unix.mkdir inside 0o755;
  Sample.write file "an older one";
  Sample.write place "";
  let with_mounts script =
    let own = if is_root then "-m" else "-rm" in
    Filename.quote_command "unshare"
      [ own; "sh"; "-e"; "-c"; script; "sh"; file; place; inside ]
  in
  if not (sh (with_mounts mount)) then Alcotest.skip ();
  (inside, place, with_mounts (mount ^ {| && exec ./save.exe "$2"|}))

let check_nothing_else inside place =
  Alcotest.(check (list string)) "only it" [ "place" ] (Sample.files inside);
  Alcotest.(check string) "what was hidden" "" (Sample.read place)

let test_mounted mount ~reason folder =
  let inside, place, save = mounted folder mount in
  check folder ~reason save;
  check_nothing_else inside place

(* The file is on a disk that is full. *)
let test_torn folder =
  let inside, place, save =
    mounted folder
      {|disk="$3.disk"; mkdir -p "$disk"
        mount -t tmpfs -o size=4k none "$disk"; touch "$disk/file"
        cat /dev/zero > "$disk/rest" || true
        mount --bind "$disk/file" "$2"|}
  in
  let said = output save in
  Expect.contains "why" ~part:"place: No space left on device. " said;
  Expect.contains "what it did"
    ~part:"neither the older nor the new one is whole now" said;
  check_nothing_else inside place

let a_file = {|mount --bind "$1" "$2"|}

let in_a_locked_folder =
  {|mount --bind "$3" "$3" && mount -o remount,bind,ro "$3" && |} ^ a_file

let test name f = Alcotest.test_case name `Quick (Sample.in_new_folder f)

let suite =
  ( "Fixed files",
    [
      test "in a folder like /tmp" test_sticky;
      test "a mount point"
        (test_mounted a_file ~reason:"Device or resource busy");
      test "in a folder that is only read"
        (test_mounted in_a_locked_folder
           ~reason:"no file can be made in its folder: Read-only file system");
      test "without room for the copy" test_torn;
    ] )
