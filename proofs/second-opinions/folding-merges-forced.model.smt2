; A model of the hypotheses of folding-merges-forced.smt2
; Says: The world is one vertex with one loop a0a1, the marker points to a0. The log: from r0 the
;   robot walks motion 0 and arrives at s0, at v0 again. Merged so far: nothing; next: each dart
;   with itself, r0 with s1, r1 with s0.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1))))
(declare-datatypes ((LogDart 0)) (((r0) (r1) (s0) (s1))))
(declare-datatypes ((Turn 0)) (((zero) (one))))
(define-fun sigma ((x Dart)) Dart (ite (= x a0) a1 a0))
(define-fun alpha ((x Dart)) Dart (ite (= x a0) a1 a0))
(define-fun next ((x LogDart)) LogDart (ite (= x r0) r1 (ite (= x r1) r0 (ite (= x s0) s1 s0))))
(define-fun place ((x LogDart)) Dart (ite (= x r1) a1 (ite (= x s0) a1 a0)))
(define-fun turn ((x0 Turn) (x1 Dart)) Dart
  (ite (and (= x0 one) (= x1 a0)) a1 (ite (and (= x0 one) (= x1 a1)) a0 x1)))
(define-fun unturn ((x0 Turn) (x1 Dart)) Dart
  (ite (and (= x0 one) (= x1 a0)) a1 (ite (and (= x0 one) (= x1 a1)) a0 x1)))
(define-fun pointed () Dart a0)
(define-fun walked ((x LogDart)) Bool (or (= x r0) (= x s0)))
(define-fun target ((x LogDart)) LogDart (ite (= x r0) s0 r0))
(define-fun home ((x LogDart)) Bool true)
(define-fun bearing ((x LogDart)) Turn (ite (= x r1) one (ite (= x s0) one zero)))
(define-fun merged0 ((x0 LogDart) (x1 LogDart)) Bool false)
(define-fun merged1 ((x0 LogDart) (x1 LogDart)) Bool
  (or (and (= x0 r0) (= x1 r0)) (and (= x0 r0) (= x1 s1)) (and (= x0 r1) (= x1 r1))
  (and (= x0 r1) (= x1 s0)) (and (= x0 s0) (= x1 r1)) (and (= x0 s0) (= x1 s0))
  (and (= x0 s1) (= x1 r0)) (and (= x0 s1) (= x1 s1))))
(define-fun f () LogDart r0)
(define-fun g () LogDart s1)

(assert (forall ((b Turn) (d Dart)) (= (unturn b (turn b d)) d)))
(assert (forall ((x LogDart)) (= (place (next x)) (sigma (place x)))))
(assert (forall ((x LogDart)) (=> (walked x) (= (place (target x)) (alpha (place x))))))
(assert (forall ((x LogDart)) (=> (home x) (= (turn (bearing x) (place x)) pointed))))
(assert (forall ((x LogDart) (y LogDart))
  (= (merged1 x y)
     (or (merged0 x y) (merged0 y x)
         (exists ((z LogDart)) (and (merged0 x z) (merged0 z y)))
         (and (home x) (home y) (= (bearing x) (bearing y)))
         (exists ((u LogDart) (v LogDart))
           (and (merged0 u v)
                (or (and (= x (next u)) (= y (next v)))
                    (and (walked u) (walked v) (= x (target u)) (= y (target v))))))))))
(assert (forall ((x LogDart) (y LogDart)) (=> (merged0 x y) (= (place x) (place y)))))
(assert (merged1 f g))
(check-sat)
