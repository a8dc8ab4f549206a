(* The extracted explorers behind JSON lines: read percepts, write motions and the estimate.
   Usage: explorer [POLICY] [LIGHTHOUSE]
   POLICY: fifo (default), lifo, nearest.  LIGHTHOUSE: directional (default), cluster, natural, door; or
   shield:X, the shield of an explorer X with Algorithm 1, under the directional lighthouse.
   X: stop (at once), spin (move 1 for ever), zigzag (1, 4, 9, ... modulo 7), algorithm1 (lifo). *)
open Certified

let usage () =
  prerr_endline "usage: explorer [fifo|lifo|nearest] [directional|cluster|natural|door|shield:X]"; exit 2

let argument i default = if Array.length Sys.argv > i then Sys.argv.(i) else default

let policy = match argument 1 "fifo" with
  | "fifo" -> fifo | "lifo" -> lifo | "nearest" -> nearest | _ -> usage ()

let say = function
  | Inl e ->
      Printf.printf "{\"estimate\":{\"sigma\":%s,\"alpha\":%s,\"here\":%d}}\n%!"
        (Json.show e.sigma_list) (Json.show e.alpha_list) e.root_number
  | Inr (k, _) -> Printf.printf "{\"move\":%d}\n%!" k

(* percept: what the explorer takes from a percept; starts told o: its first program, and its next *)
let serve percept starts =
  let current = ref None in
  try
    while true do
      let line = Json.parse (input_line stdin) in
      let o = percept (Json.field "percept" line) in
      let next, program = match Json.field "episode" line, !current with
        | Json.Null, Some (next, program) ->
            (next, match next program with Inr (_, go_on) -> go_on o | Inl _ -> program)
        | _ -> starts (Json.field "told" line) o in
      current := Some (next, program);
      say (next program)
    done
  with
  | End_of_file -> ()
  | Json.Malformed why -> prerr_endline why; exit 2

let degree p = Json.int (Json.field "degree" p)
let bearing p = match Json.field "bearing" p with Json.Null -> None | b -> Some (Json.int b)

(* a shield keeps a state: what it does in it, and what it is after the next percept *)
let shielded x =
  let r = shield_of x policy in
  let next s = match r.decides s with
    | Stop answer -> Inl answer
    | Move k -> Inr (k, fun o -> r.goes_on s o) in
  serve (fun p -> (degree p, bearing p)) (fun _ o -> (next, r.begins o))

let () = match argument 2 "directional" with
  | "directional" ->
      serve (fun p -> (degree p, bearing p))
        (fun _ o -> (algorithm1_next policy, algorithm1_starts o))
  | "cluster" ->
      serve (fun p -> (degree p, Json.int (Json.field "marks" p)))
        (fun _ o -> (cluster_next policy, cluster_starts o))
  | "door" ->
      serve (fun p -> (degree p, Json.int (Json.field "marks" p)))
        (fun _ o -> (door_next policy, door_starts o))
  | "natural" ->
      serve degree
        (fun told o ->
          let v1 = Json.int told in
          (natural_next o v1 policy, natural_starts o v1 o))
  | "shield:stop" -> shielded (fun _ -> Stop ())
  | "shield:spin" -> shielded (fun _ -> Move 1)
  | "shield:zigzag" -> shielded (fun seen -> let k = List.length seen in Move (k * k mod 7))
  | "shield:algorithm1" -> shielded (algorithm1_explorer lifo)
  | _ -> usage ()
