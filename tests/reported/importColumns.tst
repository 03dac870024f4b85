% Issue 72, 3: a table whose columns bear the names that --vary was given, and the
% errors of a spreadsheet.

%!shared folder
%! folder = tempname ();
%! mkdir (folder);
%! writeAtomic (fullfile (folder, 'in.x'), strjoin ({ ...
%!   'fix a all property/global coefficientFriction peratomtypepair 2 .5 .4 .4 .3', ...
%!   'fix b all property/global coefficientRollingFriction peratomtypepair 2 .1 .2 .2 .3', ...
%!   'print "1" file out', 'run 1'}, "\n"));
%! [status, out] = startCommand (folder, ['new --model H --script in.x --vary ', ...
%!   '"friction 1-2=0.3:0.7" --vary "rollingFriction 1-1=0.05:0.3" --target t=0.6:s ', ...
%!   '--target angle=24:deg --output out case']);
%! assert (status == 0, out);
%!function out = imported (folder, header, words)
%!  writeAtomic (fullfile (folder, 'my.csv'), ...
%!    [header, "\n1;0,369;0,211;0,556;23,3;\n2;0,563;0,096;#DIV/0!;17,8;\n"]);
%!  [status, out] = startCommand (folder, ['import my.csv case', words]);
%!  assert (status == 0, out);
%!endfunction
%!test
%! for header = {'run;friction 1-2;rollingFriction 1-1;t [s];angle [deg];remark', ...
%!               'run;Friction 2-1;Rolling friction 1-1;t;angle;remark', ...
%!               'run;friction(1,2);coefficientRollingFriction 1-1;t;angle;remark', ...
%!              'run;friction_1_2;rollingfriction 1_1;T;ANGLE;remark'}
%!   out = imported (folder, header{1}, '');
%!   for part = {'parameter +2 +0.369', 'parameter +2 +0.096', ...
%!               't: 1 result, 1 without one\n', 'angle: 2 results', 'sets +2; 2 of'}
%!     assert (! isempty (regexp (out, part{1}, 'once')), out);
%!   end
%! end
%!test
%! % one parameter in two columns: the same numbers in the other order of types, or not
%! file = fullfile (folder, 'my.csv');
%! head = "friction 1-2;friction 2-1;rollingFriction 1-1;t;angle\n";
%! writeAtomic (file, [head, "0,4;0,4;0,2;0,6;24\n"]);
%! [status, out] = startCommand (folder, 'import my.csv case');
%! assert (status == 0, out);
%! writeAtomic (file, [head, "0,4;0,5;0,2;0,6;24\n"]);
%! [status, out] = startCommand (folder, 'import my.csv case');
%! assert (status == 1 && ! isempty (strfind (out, 'are friction_1_2, and differ')), out);
%!test
%! % columns of other names
%! header = 'run;mu;mr;time (s);Winkel;remark';
%! words = [' --column mu="friction 1-2" --column mr=rollingFriction_1_1 ', ...
%!          '--column time=t --column Winkel=angle'];
%! assert (! isempty (strfind (imported (folder, header, words), '--take writes it')));
%! imported (folder, header, [words, ' --take']);
%! text = fileread (fullfile (folder, 'case', 'runs.csv'));
%! assert (strtok (text, "\n"), 'friction_1_2,rollingFriction_1_1,t,angle');
%! [status, out] = startCommand (folder, 'check case');
%! assert (! isempty (strfind (out, 'runs.csv  2 sets taken in')), out);

% SPDX-License-Identifier: GPL-3.0-only
