(* The extracted explorer behind JSON lines: reads percepts, writes motions and the estimate.
   Usage: explorer [fifo|lifo|nearest]   (default fifo) *)
open Certified

let policy = match Array.to_list Sys.argv with
  | [_] | [_; "fifo"] -> fifo
  | [_; "lifo"] -> lifo
  | [_; "nearest"] -> nearest
  | _ -> prerr_endline "usage: explorer [fifo|lifo|nearest]"; exit 2

let percept line =
  let p = Json.field "percept" line in
  (Json.int (Json.field "degree" p),
   match Json.field "bearing" p with Json.Null -> None | b -> Some (Json.int b))

let say program =
  (match algorithm1_next policy program with
   | Inl e ->
       Printf.printf "{\"estimate\":{\"sigma\":%s,\"alpha\":%s,\"here\":%d}}\n"
         (Json.show e.sigma_list) (Json.show e.alpha_list) e.root_number
   | Inr (k, _) -> Printf.printf "{\"move\":%d}\n" k);
  flush stdout

let () =
  let current = ref None in
  try
    while true do
      let line = Json.parse (input_line stdin) in
      let o = percept line in
      let program = match Json.field "episode" line, !current with
        | Json.Null, Some program ->
            (match algorithm1_next policy program with Inr (_, go_on) -> go_on o | Inl _ -> program)
        | _ -> Return (first_knowledge o) in
      current := Some program;
      say program
    done
  with
  | End_of_file -> ()
  | Json.Malformed why -> prerr_endline why; exit 2
