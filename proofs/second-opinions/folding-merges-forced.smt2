; Folding: every merge is forced, one step
; Says: Two darts of the log are merged if both are at v0 with the same bearing; if darts merged
;   before lead to them, clockwise or across a walked edge; or by symmetry and transitivity. If
;   all merges so far are of darts that are the same in every world that agrees with the log, so
;   are the next.
; Paper: V, step 2 (the embedded path is unique), applied to the log of an explorer
; Symbols:
;   Dart           the darts of a world that agrees with the log
;   LogDart        the darts of the tree of places that the log tells of
;   place          the dart of the world that a dart of the log is
;   sigma, next    the next dart clockwise, in the world and in the log
;   alpha          the other end of the same edge, in the world
;   Turn           numbers of places to turn by;  turn, unturn: (turn b d) = sigma^b(d), its inverse
;   home, bearing  sensed at a dart of the log: the marker, and the offset to the dart pointed at
;   pointed        the dart of the world that the marker points to
;   walked, target the edge of this dart of the log was walked; the dart of the log at its other end
;   merged0        the merges so far;  merged1: those and the next ones
;   f, g           two darts merged where the claim fails
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort LogDart 0)
(declare-sort Turn 0)
(declare-fun sigma (Dart) Dart)
(declare-fun alpha (Dart) Dart)
(declare-fun turn (Turn Dart) Dart)
(declare-fun unturn (Turn Dart) Dart)
(declare-const pointed Dart)
(declare-fun place (LogDart) Dart)
(declare-fun next (LogDart) LogDart)
(declare-fun walked (LogDart) Bool)
(declare-fun target (LogDart) LogDart)
(declare-fun home (LogDart) Bool)
(declare-fun bearing (LogDart) Turn)
(declare-fun merged0 (LogDart LogDart) Bool)
(declare-fun merged1 (LogDart LogDart) Bool)
(declare-const f LogDart)
(declare-const g LogDart)

; turning is reversible
(assert (forall ((b Turn) (d Dart)) (= (unturn b (turn b d)) d)))
; the world agrees with the log
(assert (forall ((x LogDart)) (= (place (next x)) (sigma (place x)))))
(assert (forall ((x LogDart)) (=> (walked x) (= (place (target x)) (alpha (place x))))))
(assert (forall ((x LogDart)) (=> (home x) (= (turn (bearing x) (place x)) pointed))))
; one step of folding
(assert (forall ((x LogDart) (y LogDart))
  (= (merged1 x y)
     (or (merged0 x y) (merged0 y x)
         (exists ((z LogDart)) (and (merged0 x z) (merged0 z y)))
         (and (home x) (home y) (= (bearing x) (bearing y)))
         (exists ((u LogDart) (v LogDart))
           (and (merged0 u v)
                (or (and (= x (next u)) (= y (next v)))
                    (and (walked u) (walked v) (= x (target u)) (= y (target v))))))))))
; induction hypothesis
(assert (forall ((x LogDart) (y LogDart)) (=> (merged0 x y) (= (place x) (place y)))))
; two darts merged
(assert (merged1 f g))

; not: the same dart of the world
(assert (not (= (place f) (place g))))
(check-sat)
