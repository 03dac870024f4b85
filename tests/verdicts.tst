% Page, console and JSON of many stored situations: one verdict, and no two
% sentences that exclude each other.

%!function check (said, name)
%!  % each row: what must not stand in one text together
%!  pairs = {'Not calibrated', 'Use the set'; ...
%!           'No measurement is missed', 'Something is missing'; ...
%!           'Not calibrated', 'Use it for'; ...
%!           'Not calibrated', '): all targets are met'; ...
%!           'No gap beyond noise', 'Missing in the model'; ...
%!           'No gap beyond noise', 'Missed by more than noise'; ...
%!           'cannot tell', 'No gap beyond noise is seen; a cause'; ...
%!           'Raise Input', 'optim.maxFunEvals (40) is used up'; ...
%!           'Raise optim', 'Input.maxNewRuns allows no'; ...
%!           'Raise', 'no set of the box'; 'Raise', 'No set of the box'; ...
%!           'Calibrated. ', 'Not calibrated'; ...
%!           'is closed; on the held-out', 'no gap beyond noise to close'; ...
%!           'NOT CALIBRATED', 'Use the set'; ...
%!           'NOT CALIBRATED', 'use it for'; ...
%!           'NOT CALIBRATED', '): all targets are met'; ...
%!           'WHICH: NO GAP', 'cannot tell'; ...
%!           'WHICH: NO GAP', 'Missing in the model'; ...
%!           'NO GAP', '<-- off'; 'NO GAP', 'HOW FAR'; ...
%!           'No measurement is missed', '<-- off'; ...
%!           'No measurement is missed', 'Missing in the model'; ...
%!           'cannot be judged from so few', 'range, noise makes'; ...
%!           'No DEM run was made', 'DEM: '};
%!  has = @(text) ~isempty (strfind (said, text));
%!  for k = 1:rows (pairs)
%!    assert (! (has (pairs{k, 1}) && has (pairs{k, 2})), ...
%!            sprintf ('%s: %s | %s', name, pairs{k, :}));
%!  end
%!  for text = {'Use the model', 'to close', 'NaN', 'Inf ', 'odds', ...
%!              'nine tenths', '121 %', 'closes 0 %', 'mean of 1 run', ...
%!              'e+22', 'e-22', 'Sobol'}
%!    assert (! has (text{1}), sprintf ('%s: %s', name, text{1}));
%!  end
%!endfunction
%!function text = plain (html)
%!  % what is read of the first screen
%!  part = regexp (html, '<header.*?</header>', 'match', 'once');
%!  text = regexprep (part, '<[^>]*>', '');
%!  for sign = {'&gt;', '>'; '&lt;', '<'; '&quot;', '"'; '&amp;', '&'}'
%!    text = strrep (text, sign{:});
%!  end
%!endfunction

%!test
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! Case = newCase (raw);
%! list = verdictCase ();
%! assert (numel (list) >= 30);
%! root = fileparts (which ('DEcalioc'));
%! for situation = list
%!   verdictCase (raw.folder, situation);
%!   page = fileread (writePage (Case));
%!   assert (isempty (strfind (page, 'could not be made')), situation.name);
%!   first = plain (page);
%!   console = evalc ('sayStatus (root, raw.folder, {})');
%!   coded = @(x) jsondecode (jsonencode (x));
%!   v = decideCase (coded (situation.c), coded (situation.gap));
%!   check ([first, console], situation.name);
%!   said = verdictConsole (situation, Case);
%!   check (said, ['printed of ', situation.name]);
%!   for text = [{v.action}, v.usableFor, v.notFor, {v.numbers.text}]
%!     assert (isempty (situation.c) || ! isempty (strfind (said, text{1})), ...
%!             sprintf ('printed of %s: %s', situation.name, text{1}));
%!   end
%!   % JSON, console and first screen say the same, word for word
%!   for text = [{v.word, v.sentence, v.gap, v.action}, v.usableFor, ...
%!               v.notFor, {v.numbers.text}]
%!     assert (! isempty (strfind (first, text{1})) || isempty (text{1}), ...
%!             sprintf ('page of %s: %s', situation.name, text{1}));
%!     known = isempty (situation.c) && isempty (situation.gap);
%!     assert (known || ! isempty (strfind (console, text{1})) || ...
%!             isempty (text{1}), ...
%!             sprintf ('console of %s: %s', situation.name, text{1}));
%!   end
%!   assert (! v.usable || isequal (situation.c.converged, true));
%!   assert (! isempty (v.action));
%!   assert (! any (strcmp ({v.numbers.text}, '-')), situation.name);
%!   assert (! v.usable || strcmp (v.word, 'Calibrated'));
%! end
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (raw.folder, 's');

%!test
%! % single sentences that had been wrong
%! list = verdictCase ();
%! of = @(name) list(strcmp ({list.name}, name));
%! coded = @(x) jsondecode (jsonencode (x));
%! decide = @(s) decideCase (coded (s.c), coded (s.gap));
%! v = decide (of ('met, blind'));
%! assert (v.class, 'open');
%! assert (! isempty (strfind (v.notFor{1}, 'cohesion, drag')));
%! v = decide (of ('met, held out tells'));
%! assert (v.class, 'open');
%! assert (! isempty (strfind (v.notFor{1}, 'difference')));
%! assert (! isempty (strfind (v.action, 'Fit difference too')));
%! v = decide (of ('missed, held out far off'));
%! assert (! isempty (strfind (v.cause.closed, ...
%!                             'all is closed; on the held-out ones it ca')));
%! assert (! isempty (strfind (v.cause.closed, 'As much is closed by drag')));
%! assert (! isempty (strfind (v.numbers(3).text, '41 kJ/m3 (31 to 58)')));
%! v = decide (of ('missed, as many unknowns as targets'));
%! assert (! isempty (strfind (v.cause.closed, 'judged from so few')));
%! v = decide (of ('missed, several'));
%! assert (isempty (strfind (v.action, 'once more')));
%! v = decide (of ('missed, a test tells'));
%! assert (! isempty (strfind (v.action, 'measure First once more')));
%! % a cause that cannot be seen is not said to be missing; where no single
%! % measurement is missed, that is not said beside a cause either
%! s = of ('missed, several');
%! s.gap.where.p = 0.3;
%! [s.gap.where.targets.p] = deal (0.5);
%! v = decide (s);
%! assert (v.cause.kind, 'several');
%! assert (! isempty (strfind (v.cause.where, 'No single measurement')));
%! s.gap.which.cannotSee = {'cohesion', 'drag'};
%! v = decide (s);
%! assert (v.cause.kind, 'cannot tell');
%! assert (v.gap, ['These targets cannot tell whether something is ', ...
%!                 'missing. If so, most likely: cohesion.']);
%! assert (v.cause.closed, '');
