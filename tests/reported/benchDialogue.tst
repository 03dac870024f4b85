% Issue 72, 3: the dialogue of new --bench in the user's terms: diameter, bulk density,
% turns a minute, the rig's own sizes, several readings of a result.

%!function [folder, out] = talk (benches, answers)
%!  root = fileparts (fileparts (which ('startToolbox')));
%!  folder = tempname ();
%!  said = tempname ();
%!  writeAtomic (said, [strjoin(answers, "\n"), "\n"]);
%!  command = sprintf (['cd %s && DECALIOC_ASKS=yes DECALIOC_CALLED_IN=/tmp octave-cli ', ...
%!                      '--norc --no-gui infrastructure/wings/command/commandMain.m new ', ...
%!                      '--bench %s %s < %s 2>&1'], shellQuote (root), benches, folder, said);
%!  [status, out] = system (command);
%!  assert (status == 0, out);
%!endfunction
%!test
%! % Ctrl-D
%! said = '';
%! try
%!   talk ('Heap', {'4 mm'});
%! catch err
%!   said = err.message;
%! end
%! assert (! isempty (strfind (said, 'got the end of the input. Nothing was made')), said);
%! assert (isempty (strfind (said, 'called from')), said);
%!function v = sizesIn (folder)
%!  found = regexp (fileread (fullfile (folder, 'loadInput.m')), ...
%!                  'modelVars\.(\w+) = ([^;]*);', 'tokens');
%!  for pair = found
%!    v.(pair{1}{1}) = str2double (pair{1}{2});
%!  end
%!endfunction
%!test
%! % grains, sizes of the heap, readings with decimal points and commas, and a slip
%! answers = {'4 mm', '690', '', '63 mm', 'back', '36 mm', '', '23 g', '', '', ...
%!            '31.4, 32.0, 30.6', '', 'heavy', '14,1; 13,9; 14,3 g', ''};
%! [folder, out] = talk ('Heap', answers);
%! for part = {'bulk density as poured', 'grains fill 0.6 of the volume', '[1150]', ...
%!             'inner tube diameter, m [0.03]', ...
%!             'mass filled into the tube, or height in it, kg [0.02185]', '''heavy''', ...
%!             'tolerance  Heap slope 7 %, Heap massOnPlate 5 %: twice what one run', ...
%!             'limits     coefFrictionPP 0.2 to 0.8', '31.4, 32.0, 30.6 deg'}
%!   assert (! isempty (strfind (out, part{1})), out);
%! end
%! v = sizesIn (folder);
%! assert ([v.radiusP, v.densityP, v.tubeRadius, v.heapSolid], ...
%!         [0.002, 1150, 0.018, 0.023 / 1150], 1e-9);
%! lines = readMeasured (fullfile (folder, 'measured.csv'), {'Heap'});
%! mass = lines(strcmp ({lines.name}, 'massOnPlate'));
%! assert ({[mass.value], unique({mass.unit})}, {[14.1, 13.9, 14.3], {'g'}});
%! assert ([lines(strcmp ({lines.name}, 'slope')).value], [31.4, 32, 30.6]);
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0 && ! isempty (strfind (out, 'mean of repeated trials: slope')), out);
%!test
%! % turns a minute; the questions for results say the speed of the case
%! [folder, out] = talk ('Drum', {'3 mm', '', '2500', '4', '100 mm', '', '0.3', '10', '20', ...
%!                                '30', '38.2 37.5', '', '', '', '', '', '', '', ''});
%! v = sizesIn (folder);
%! assert ([v.speed1, v.speed2, v.speed3], [10, 20, 30] * pi / 30, 1e-4);
%! assert ([v.drumRadius, v.drumSolid, v.densityP], [0.05, 0.18, 2500], 1e-9);
%! for part = {'4 m? Give a unit, such as 4 mm.', '30 % for the bed with its voids, 18 % solid', ...
%!             'taken as 10 turns per minute'}
%!   assert (! isempty (strfind (out, part{1})), out);
%! end
%! assert (! isempty (strfind (out, 'its middle at 10 turns per minute, measured')), out);

% SPDX-License-Identifier: GPL-3.0-only
