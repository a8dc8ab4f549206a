(* The extracted checker.  check_correct in Checker.v says what its verdict means.

   Usage: checker EDGES [--limit paper|two-vertices|N|TABLE] [--universe all|simple]
            [--lighthouse directional|cluster|natural] [--timeout SECONDS]
            (--policy fifo|lifo|nearest | --exec PROGRAM [ARGUMENT ...])

   TABLE: {"n m d0": limit, ...}, a limit for each number of vertices, edges and darts of v0 that occurs.
   The explorer is Algorithm 1 under a policy, or a program (pipe.ml).  One line is written, a JSON object:
     {"verdict": "holds", "edges": m, "runs": n, ...}     right within the limit in every world
     {"verdict": "refuted", "edges": m, ..., "refutations": [...]}   m: the least; all worlds with m edges
                                                                     in which it is not
     {"verdict": "no function", "history", "before", "now"}   the program has not always said the same
   and under the directional lighthouse "open": the worlds with at most that many edges whose log, folded,
   leaves a dart open, so that an explorer that stops there does not find all maps (unfolded_refutes).
   Exit code 2: no verdict, and one line on stderr that says why. *)
open Certified

let fail why = prerr_endline ("checker: " ^ why); exit 2
let number text =
  let digits = text <> "" && String.for_all (function '0' .. '9' -> true | _ -> false) text in
  if digits then int_of_string_opt text else None
let usage () =
  fail "usage: checker EDGES [--limit paper|two-vertices|N|TABLE] [--universe all|simple]\n\
        \         [--lighthouse directional|cluster|natural] [--timeout SECONDS]\n\
        \         (--policy fifo|lifo|nearest | --exec PROGRAM [ARGUMENT ...])"

(* ---- Options ---- *)
type explorer = Policy of policy | Program of string array

let limit_named text = match text with
  | "paper" -> fun n m _ -> paper_limit n m
  | "two-vertices" -> two_vertices_limit
  | _ ->
      match number text with
      | Some k -> fun _ _ _ -> k
      | None ->
          let table = match Json.parse text with
            | exception Json.Malformed why -> fail ("--limit: " ^ why)
            | Json.Object _ as table -> table
            | _ -> usage () in
          fun n m d0 ->
            match Json.field (Printf.sprintf "%d %d %d" n m d0) table with
            | Json.Int k when k >= 0 -> k
            | _ -> fail (Printf.sprintf "no limit for n = %d, m = %d, d0 = %d" n m d0)

let edges = ref 0 and limit = ref "paper" and universe = ref AllWorlds
and lighthouse = ref "directional" and timeout = ref 10. and explorer = ref None

let rec read = function
  | [] -> ()
  | "--limit" :: text :: rest -> limit := text; read rest
  | "--universe" :: name :: rest ->
      universe := (match name with "all" -> AllWorlds | "simple" -> SimpleWorlds | _ -> usage ());
      read rest
  | "--lighthouse" :: name :: rest -> lighthouse := name; read rest
  | "--timeout" :: text :: rest ->
      timeout := (match float_of_string_opt text with Some s when s > 0. && s < 1e6 -> s | _ -> usage ());
      read rest
  | "--policy" :: name :: rest ->
      explorer := Some (Policy (match name with
        | "fifo" -> fifo | "lifo" -> lifo | "nearest" -> nearest | _ -> usage ()));
      read rest
  | "--exec" :: (_ :: _ as command) -> explorer := Some (Program (Array.of_list command))
  | _ -> usage ()

(* ---- The verdict ---- *)
let words_of_said = function
  | Pipe.Motion k -> Printf.sprintf "{\"move\":%d}" k
  | Pipe.Estimate e ->
      Printf.sprintf "{\"estimate\":{\"sigma\":%s,\"alpha\":%s,\"here\":%d}}"
        (Json.show e.sigma_list) (Json.show e.alpha_list) e.root_number
  | Pipe.Fault (law, how) -> Printf.sprintf "{\"fault\":%s,\"how\":%s}" (Json.quote law) (Json.quote how)

let words_of_finding = function
  | NoAnswer -> "no answer within the limit"
  | Judged IsRight -> "right" | Judged WrongPose -> "pose" | Judged WrongMap -> "map"

let world_of (map, place) =
  Printf.sprintf "\"sigma\":%s,\"alpha\":%s,\"place\":%d" (Json.show map.sigma_list)
    (Json.show map.alpha_list) place

let listed show l = "[" ^ String.concat "," (Tail.map show l) ^ "]"

(* folds: for a run's first percept and steps, whether its log leaves no dart open; None: not asked
   fault: how a run through these percepts has broken off *)
let judge_all r senses admits folds fault =
  let limit = limit_named !limit in
  let up_to m = List.init m (fun j -> j + 1) in
  let runs m = List.fold_left (fun n j -> n + List.length (worlds admits j)) 0 (up_to m) in
  let percepts w =
    let (steps, answer), _ = run_in r limit senses w in
    (senses (fst w) (snd w) (fst w).root_number, steps, answer) in
  let opened m = match folds with
    | None -> ""
    | Some folds ->
        let is_open w = let first, steps, answer = percepts w in answer <> None && not (folds first steps) in
        let found = List.concat_map (fun j -> Tail.filter is_open (worlds admits j)) (up_to m) in
        Printf.sprintf ",\"open\":%s" (listed (fun w -> "{" ^ world_of w ^ "}") found) in
  let refutation w =
    let first, steps, _ = percepts w in
    let law = match fault (first :: Tail.map snd steps) with
      | None -> ""
      | Some (law, how) -> Printf.sprintf ",\"fault\":%s,\"how\":%s" (Json.quote law) (Json.quote how) in
    Printf.sprintf "{%s,\"finding\":%s%s}" (world_of w)
      (Json.quote (words_of_finding (examine r limit senses w))) law in
  if check r limit senses admits !edges then
    Printf.printf "{\"verdict\":\"holds\",\"edges\":%d,\"runs\":%d%s}\n" !edges (runs !edges) (opened !edges)
  else
    let rec first_refuted j = match refutations r limit senses admits j with
      | [] -> first_refuted (j + 1)
      | found -> j, found in
    let j, found = first_refuted 1 in
    Printf.printf "{\"verdict\":\"refuted\",\"edges\":%d,\"runs\":%d,\"refutations\":%s%s}\n" j (runs j)
      (listed refutation found) (opened j)

(* an explorer of the policy, or the program behind the pipe *)
let under senses admits of_policy words folds =
  match !explorer with
  | Some (Policy policy) -> judge_all (of_policy policy) senses admits folds (fun _ -> None)
  | Some (Program command) ->
      let most_darts = 2 * !edges in
      (* as many as the step budget of allworlds check lets pass in the largest of these worlds *)
      let most_checkpoints = 8 * paper_limit (!edges + 1) !edges + 101 in
      let t = Pipe.create words ~timeout:!timeout ~most_darts ~most_checkpoints command in
      Fun.protect ~finally:(fun () -> Pipe.stop t) (fun () ->
        try judge_all (Pipe.resumption t) senses admits folds (Pipe.fault t) with
        | Pipe.Not_a_function { history; before; now } ->
            Printf.printf "{\"verdict\":\"no function\",\"history\":%s,\"before\":%s,\"now\":%s}\n"
              (listed Fun.id history) (words_of_said before) (words_of_said now))
  | None -> usage ()

let percept degree marks bearing =
  Printf.sprintf "{\"degree\":%d,\"marks\":%d,\"bearing\":%s}" degree marks
    (match bearing with None -> "null" | Some b -> string_of_int b)

let () =
  (match Array.to_list Sys.argv with
   | _ :: m :: rest ->
       (match number m with Some k when k >= 1 -> edges := k | _ -> usage ());
       read rest
   | _ -> usage ());
  let untold _ = "" in
  try match !lighthouse with
    | "directional" ->
        under directional_senses (in_universe_in !universe) algorithm1_resumption
          { Pipe.show = (fun (d, b) -> percept d (if b = None then 0 else 1) b); told = untold; degree = fst }
          (Some (fun first steps -> fst (folded_log first steps)))
    | ("cluster" | "natural") when !universe <> AllWorlds ->
        fail "--universe simple goes with the directional lighthouse"
    | "cluster" ->
        under cluster_senses one_edge_in cluster_resumption
          { Pipe.show = (fun (d, marks) -> percept d marks None); told = untold; degree = fst } None
    | "natural" ->
        under natural_senses natural_in natural_resumption
          { Pipe.show = (fun (d, _) -> percept d 0 None);
            told = (fun (_, b) -> Printf.sprintf ",\"told\":%d" b); degree = fst } None
    | _ -> usage ()
  with
  | Unix.Unix_error (error, _, what) -> fail (Printf.sprintf "%s: %s" what (Unix.error_message error))
  | Stack_overflow -> fail "out of stack"
  | Out_of_memory -> fail "out of memory"
  | Invalid_argument why | Failure why | Sys_error why -> fail why
