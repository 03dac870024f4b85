% Issue 72, 3: a drum turned at 10 turns a minute: words said 2 rad/s, the default, and
% the line of slope1 lay over the picture of the third speed.

%!function Case = caseOf (bench, sizes, rows)
%!  folder = tempname ();
%!  [status, out] = startCommand (tempdir (), ['new --bench ', bench, ' ', folder]);
%!  assert (status == 0, out);
%!  file = fullfile (folder, 'loadInput.m');
%!  for pair = sizes'
%!    text = fileread (file);
%!    assert (! isempty (strfind (text, pair{1})), text);
%!    writeAtomic (file, strrep (text, pair{:}));
%!  end
%!  writeAtomic (fullfile (folder, 'measured.csv'), ...
%!               sprintf ('%s\n', 'model,name,value,unit,tol', rows{:}));
%!  root = fileparts (fileparts (which ('startToolbox')));
%!  here = cd (folder);
%!  back = onCleanup (@() cd (here));
%!  clear loadInput loadEffects
%!  Case = loadCase (root, folder, 'reading');
%!endfunction
%!test
%! Case = caseOf ('Drum', {'speed1 = 2;', 'speed1 = 1.047;'}, ...
%!                {'Drum,slope1,38.2,deg,3%', 'Drum,slope1,37.5,deg,', ...
%!                 'Drum,slope2,41,deg,3%'});
%! info = targetInfo (Case);
%! assert ([info.at], [1.047, 4]);
%! assert (! isempty (strfind (info(1).text, 'at 1.047 rad/s')), info(1).text);
%! assert (! isempty (strfind (info(2).text, 'at 4 rad/s')), info(2).text);
%! assert ([newProblem(Case).coordinate](1), 1.047);
%! grains = [(0:0.5:10)', zeros(21, 1), (0:0.5:10)', ones(21, 1)];
%! lines = @(k) numel (measuredLines (Case, 1, sprintf ('surface%d.dump', k), 3 - k, grains));
%! assert (arrayfun (lines, 1:3), [1, 1, 0]);
%!test
%! % slots in mm, loads in Pa
%! Case = caseOf ('SlotBin,Shear', {'slot1 = 0.02;', 'slot1 = 0.025;'; ...
%!                                  'load3 = 1800;', 'load3 = 2400;'}, ...
%!                {'SlotBin,rate1,0.05,kg/s,5%', 'Shear,densityHigh,650,kg/m3,2%', ...
%!                 'Shear,densityLow,640,kg/m3,2%'});
%! info = targetInfo (Case);
%! assert (! isempty (strfind (info(1).text, 'slot of 25 mm')), info(1).text);
%! assert ([info.at], [0.025, 2400, 300]);

% SPDX-License-Identifier: GPL-3.0-only
