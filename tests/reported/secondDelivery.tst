% A second delivery, measured by one number and by three; nothing is run. Once the
% first words named a cause that might be nothing (mean size 0.2 % larger, seen from
% 19 %), and one number had two causes.

%!function [gap, out] = diagnosed (folder)
%!  [status, out] = startCommand (folder, 'diagnose');
%!  assert (status, 0);
%!  gap = readJsonFile (fullfile (folder, 'gap', 'gap.json'));
%!endfunction
%!function put (folder, name, change)
%!  file = fullfile (folder, name);
%!  writeAtomic (file, change (fileread (file)));
%!endfunction
%!function has (text, part)
%!  assert (! isempty (strfind (text, part)), [part, "\n", text]);
%!endfunction

%!test
%! % three numbers: what has changed comes first, then the one cause that carries it
%! folder = reportedCase ('secondDelivery');
%! [gap, out] = diagnosed (folder);
%! assert ({gap.cause.code, gap.verdict.cause.names}, {'likely', {'cohesion'}});
%! has (out, "\n3 of 3 results changed by more than noise: slope 4.47 deg steeper");
%! has (out, 'massOnPlate 1.05 g more (14.1 to 15.15)');       % as it was weighed
%! has (out, "\nMost likely cause: cohesion (0.9");
%! verdict = out(strfind (out, 'results changed by'):end);
%! assert (isempty (strfind (verdict, 'mean size')), verdict);
%! % an origin is carried by what acts; one number for the strength
%! moisture = gap.which.cause(strcmp ({gap.which.cause.name}, 'moisture'));
%! assert (any (strcmp (moisture.effects, 'cohesion')));
%! head = headDefaults (fullfile (folder, 'gap', 'calibrated.head'));
%! assert (gap.which.strength.cohesion.variables.cohesionPP(1), head.cohesionPP, 1e-6);
%! has (out, quantity (head.cohesionPP, 'J/m3'));
%! assert (isempty (regexp (out, 'e-0\d')), out);
%! % where deviation is (measured - predicted) over both noises
%! for T = gap.where.targets'
%!   assert (T.deviation, (T.measured - T.predicted) / hypot (T.sdMeasured, T.sdPredicted), ...
%!           1e-9);
%! end
%! % the page says the same first
%! page = fileread (fullfile (folder, 'results', 'report.html'));
%! has (page, '<p class="word">3 of 3 results changed');
%! % what the user knows is not asked
%! put (folder, 'loadInput.m', @(t) strrep (t, 'Input.seed = 1;', ...
%!                                          "Input.seed = 1; Input.origin = 'batch';"));
%! [~, said] = startCommand (folder, 'status');
%! has (said, 'effects changed');
%! [gap, out] = diagnosed (folder);
%! has (out, 'You say what it was: another batch.');
%! assert (isempty (strfind (out, 'Possible origin')));

%!test
%! % one number names no cause, and says what to measure
%! folder = reportedCase ('secondDelivery');
%! put (folder, 'measured.csv', @(t) regexprep (t, 'second,(Heap,mass|Drum)[^\n]*\n', ''));
%! [gap, out] = diagnosed (folder);
%! assert (gap.cause.code, 'oneNumber');
%! assert (gap.action.code, 'measureToo');
%! assert (gap.action.field', {'Heap massOnPlate', 'Drum slope1'});
%! has (out, "\nChanged: slope 4.47 deg steeper (31.33 to 35.8), 6.3 times the noise.\n");
%! at = strfind (out, 'Changed: slope');     % what runs are made of comes between
%! verdict = out(at(end):end);
%! for word = {'cohesion', 'Possible origin', 'moist'}
%!   assert (isempty (strfind (verdict, word{1})), verdict);
%! end
%! assert (isempty (gap.verdict.cause.names));
%! for one = gap.reference.conditions'
%!   assert (isempty (one.names));
%! end

% SPDX-License-Identifier: GPL-3.0-only
