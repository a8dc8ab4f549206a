(* ---------------------------------------------------------------------------------------------
   A tour of S: a closed walk past all its vertices, twice along the edges of a spanning tree.

   A vertex was found by its dart 0, from a vertex that was found before it.  Those edges are the tree.

     grown S              the dart 0 of each vertex but the first leads to a vertex of a smaller number;
                          both augmentations keep it: grown_loop, grown_vertex.
     tour S v             the darts by which the robot leaves, one after the other, on a closed walk past
                          the vertices 0 to v: a closed walk past those before v, from the vertex from
                          which v was found, with the way to v and back put before it.
     begun_at u t         the closed walk t, begun at its vertex u.
     far S d              the other end of d; of an open dart, d: it is where the robot is in S.
     leads_on S d d'      who has left by d can leave by d'.
     tour_walks           a robot at the open dart e can make the tour that begins at its vertex.
     tour_visits          each vertex of S is that of e, or that of a dart of the tour.
     size_tour            2 (s-1) traversals, where S has s vertices.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps PartialMaps Paths.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition grown S := forall v, 0 < v < size (degrees S) ->
  exists2 f, partner S (v, 0) = Some f & f.1 < v.

Definition far S d := odflt d (partner S d).
Lemma far_open S e : is_open S e -> far S e = e.
Proof.
case/andP=> _ oe; rewrite /far; case P: (partner S e) => [f|] //.
by case/negP: oe; apply/mapP; exists (e, f); rewrite ?partnerP.
Qed.

Definition leads_on S : rel dart := fun d d' => (far S d).1 == d'.1.

Definition begun_at u (t : seq dart) := rot (find (fun d => d.1 == u) t) t.
Fixpoint tour S v : seq dart :=
  if v is v'.+1 then
    let e := far S (v, 0) in [:: e, (v, 0) & begun_at e.1 (tour S v')]
  else [::].
Definition tour_from S u := begun_at u (tour S (size (degrees S)).-1).

Section InWorld.
Variables (G : combinatorial_map) (v0 : G).
Local Notation embedded := (@embedded G v0).

(* ---- The tree ---- *)
Lemma grown_loop S e h : is_open S e -> is_open S h -> grown S -> grown (add_loop S e h).
Proof.
move=> oe /andP[_ oh] H v lv; have [f P lt] := H v lv; exists f => //.
exact: (@partner_mono S _ _ e h).
Qed.

Lemma grown_vertex S r e k : embedded S r -> is_open S e -> grown S -> grown (add_vertex S e k).
Proof.
move=> I oe H v /andP[v0' lv]; move: lv; rewrite size_rcons ltnS leq_eqVlt => /orP[/eqP vE|lv].
  have [ke _] := andP oe; have [le _] := andP ke; exists e; last by rewrite vE.
  have ne : e != new_dart S by apply/eqP=> E; move: (new_unknown S); rewrite -E ke.
  by rewrite vE /partner /= (negbTE ne) eqxx.
have [|f P lt] := H v; first by rewrite v0'.
by exists f => //; exact: (@partner_mono S _ _ e (new_dart S) _ _ oe (new_unexplored I)).
Qed.

(* ---- The tour ---- *)
Section Embedded.
Variables (S : partial_map) (r : seq G).
Hypotheses (I : embedded S r) (T : grown S).

Lemma partner_back e f : partner S e = Some f -> partner S f = Some e.
Proof.
move/partnerP=> m; have [ke kf E m'] := embedded_links I m.
have [|g P] := @partner_total S f; first by apply/mapP; exists (f, e).
have [_ kg F _] := embedded_links I (partnerP P); rewrite P; congr Some.
by apply: (phi_inj I kg ke); rewrite -F -E alphaK.
Qed.

Lemma begun_at_head u t : has (fun d => d.1 == u) t ->
  exists d t', begun_at u t = d :: t' /\ d.1 = u.
Proof.
move=> H; rewrite /begun_at /rot (drop_nth (0, 0)) -?has_find //.
by do 2 eexists; split; [reflexivity | exact/eqP/(nth_find (0, 0) H)].
Qed.

Lemma size_tour v : size (tour S v) = 2 * v.
Proof. by elim: v => //= v IH; rewrite size_rot IH mulnS. Qed.

Lemma tour_has u v : u <= v -> 0 < v -> v < size (degrees S) -> has (fun d => d.1 == u) (tour S v).
Proof.
elim: v => // v IH; rewrite leq_eqVlt => /orP[/eqP->|uv] _ lv /=; first by rewrite eqxx orbT.
case: (posnP v) uv IH lv => [->|v0' uv IH lv]; last by rewrite has_rot IH ?orbT // ltnW.
by rewrite ltnS leqn0 => /eqP-> _ lv; have [//|f P] := T (v := 1); rewrite /far P ltnS leqn0 /= => ->.
Qed.

Lemma tour_explored v : v < size (degrees S) -> all (explored S) (tour S v).
Proof.
elim: v => //= v IH lv; have [//|f P _] := T (v := v.+1).
have ex x y : partner S x = Some y -> explored S x by move/partnerP=> m; apply/mapP; exists (x, y).
by rewrite (eq_all_r (mem_rot _ _)) /far P (ex _ _ P) (ex _ _ (partner_back P)) IH // ltnW.
Qed.

Lemma tour_cycle v : v < size (degrees S) -> cycle (leads_on S) (tour S v).
Proof.
elim: v => // v IH lv; have [//|f P lt] := T (v := v.+1).
have C : cycle (leads_on S) (begun_at f.1 (tour S v)) by rewrite rot_cycle IH // ltnW.
have J d : d.1 = f.1 -> leads_on S (v.+1, 0) d by move=> E; rewrite /leads_on /far P E /=.
rewrite [tour _ _]/= /far P /= {1}/leads_on /far (partner_back P) eqxx /=.
case: (posnP v) lt C J => [-> _ _ J|v0' lt C J]; first by rewrite /= J.
have [d [t [E dE]]] := begun_at_head (@tour_has f.1 v lt v0' (ltnW lv)); rewrite E in C *.
by move: C; rewrite /= J // !rcons_path /leads_on dE.
Qed.

Theorem tour_walks e : is_open S e ->
  path (leads_on S) e (tour_from S e.1) && all (explored S) (tour_from S e.1).
Proof.
move=> oe; have /andP[/andP[le _] _] := oe; set n := size (degrees S) in le *; have n0 : n.-1 < n.
  by rewrite prednK // (leq_ltn_trans _ le).
rewrite (eq_all_r (mem_rot _ _)) tour_explored // andbT /tour_from -/n.
have C : cycle (leads_on S) (begun_at e.1 (tour S n.-1)) by rewrite rot_cycle tour_cycle.
case: (posnP n.-1) C => [->|n1] //.
have len : e.1 <= n.-1 by rewrite -ltnS prednK // (leq_ltn_trans _ le).
have [d [t [-> dE]]] := begun_at_head (tour_has len n1 n0).
by rewrite /= rcons_path => /andP[-> _]; rewrite andbT /leads_on far_open // dE.
Qed.

Theorem tour_visits e v : known S e -> v < size (degrees S) ->
  exists2 d, d \in e :: tour_from S e.1 & d.1 = v.
Proof.
case/andP=> le _; set n := size (degrees S) in le *; rewrite /tour_from -/n => lv.
have n0 : 0 < n by exact: leq_ltn_trans lv.
case: (posnP n.-1) => [E|n1].
  exists e; first exact: mem_head; have n1 : n = 1 by rewrite -(prednK n0) E.
  by move: le lv; rewrite n1 !ltnS !leqn0 => /eqP-> /eqP->.
have [|||d m /eqP dE] := hasP (tour_has (u := v) (v := n.-1) _ _ _); rewrite ?prednK //.
  by rewrite -ltnS prednK.
by exists d => //; rewrite inE mem_rot m orbT.
Qed.
End Embedded.
End InWorld.
