; A test that matches to the end proves its hypothesis: induction step
; Says: If the robot, in x, executes the motions of the hypothesis h and senses all that is
;   expected, then x is the dart that h stands for. Step: true for the motions w, hence for k
;   followed by w.
; Paper: IV, case (3); V, step 2 ('when a hypothesis is accepted ...')
; Symbols:
;   Dart, MapDart  the darts of the world G; the darts of the map S
;   phi            the dart of G that a dart of S stands for (the paper's phi)
;   known          the dart is in S (its vertex is)
;   Degree         degrees of vertices, compared only
;   alpha          the other end of the same edge, in G; partner: in S, for explored darts
;   turn, back     sigma^k for a fixed k, and its inverse, in G; turn_map: sigma^k in S
;   degree, marked             percepts in G: degree, and whether the marker is there
;   degree_map, home           the same as expected from S
;   match_w        (match_w h x): w leads from h through S to v0, and the percepts of the robot
;                  walking w from x are those expected from h.  match_kw: for k followed by w
;   h, x           hypothesis and true dart where the claim fails
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort MapDart 0)
(declare-sort Degree 0)
(declare-fun alpha (Dart) Dart)
(declare-fun turn (Dart) Dart)
(declare-fun back (Dart) Dart)
(declare-fun marked (Dart) Bool)
(declare-fun degree (Dart) Degree)
(declare-fun phi (MapDart) Dart)
(declare-fun known (MapDart) Bool)
(declare-fun explored (MapDart) Bool)
(declare-fun partner (MapDart) MapDart)
(declare-fun turn_map (MapDart) MapDart)
(declare-fun home (MapDart) Bool)
(declare-fun degree_map (MapDart) Degree)
(declare-fun match_w (MapDart Dart) Bool)
(declare-fun match_kw (MapDart Dart) Bool)
(declare-const h MapDart)
(declare-const x Dart)

; an edge has two ends
(assert (forall ((d Dart)) (= (alpha (alpha d)) d)))
; turning is reversible
(assert (forall ((d Dart)) (= (back (turn d)) d)))
; I-1: turning in S is turning in G (turns-carried-over)
(assert (forall ((e MapDart))
  (=> (known e) (and (known (turn_map e)) (= (phi (turn_map e)) (turn (phi e)))))))
; I-1: explored edges of S are edges of G
(assert (forall ((e MapDart))
  (=> (explored e) (and (known (partner e)) (= (phi (partner e)) (alpha (phi e)))))))
; a match along k followed by w
(assert (forall ((e MapDart) (d Dart))
  (= (match_kw e d)
     (and (= (degree_map e) (degree d)) (= (home e) (marked d))
          (explored (turn_map e)) (match_w (partner (turn_map e)) (alpha (turn d)))))))
; induction hypothesis
(assert (forall ((e MapDart) (d Dart)) (=> (and (known e) (match_w e d)) (= d (phi e)))))
; the test of h matches
(assert (known h))
(assert (match_kw h x))

; not: the hypothesis is true
(assert (not (= x (phi h))))
(check-sat)
