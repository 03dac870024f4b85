% Issue 72, 3: measured points of --curve in the tables that people have. A decimal
% comma made 0,5;520 to the place 0, the value 5 and the uncertainty 520.

%!function [out, words] = made (text, name)
%!  folder = tempname ();
%!  mkdir (folder);
%!  put = @(name, text) writeAtomic (fullfile (folder, name), text);
%!  put ('in.x', "variable mu index 0.5\nprint \"${mu}\" file out\nrun 1\n");
%!  put ('points.csv', text);
%!  [status, out] = startCommand (folder, ['new --model H --script in.x --vary ', ...
%!                    'mu=0.3:0.7 --curve time:n=', name, ' --output out']);
%!  file = fullfile (folder, 'H', 'measured.csv');
%!  if isfile (file)
%!    assert (status == 0, out);
%!    out = readMeasured (file, {'H'});
%!    words = fileread (fullfile (folder, 'H', 'DEMmodels', 'H', 'results.csv'));
%!  end
%!endfunction
%!test
%! % as reported; no header; by tabs, by blanks; columns in another order
%! for text = {"time;n\n0,5;520\n0,6;400,5\n", "0,5;520\n0,6;400,5\n", ...
%!             "0,5\t520\n0,6\t400,5\n", "0,5 520\n0,6 400,5\n", ...
%!             "sep=;\r\ntime;n\r\n0,5;520\r\n;;\r\n0,6;400,5\r\n", ...
%!             "remark,n,time\nx,520,0.5\ny,400.5,0.6\n"}
%!   m = made (text{1}, 'points.csv');
%!   assert ([m.at; m.value], [0.5, 0.6; 520, 400.5]);
%!   assert ([m.sd], [0, 0]);
%! end
%!test
%! for row = {"time;n\n0,5;520\n0,6;many\n", 'points.csv', 'got 0.6 many in line 3'; ...
%!            "time,n\n0,5,520\n0,6,400\n", 'points.csv', 'save it with semicolons'; ...
%!            "0,5,520\n0,6,400\n", 'points.csv', 'commas cannot be told apart: write 0.5,520'; ...
%!            "time;n\n0,5;520\n", 'points.csv', 'got 1 such lines'; ...
%!            "x", 'pointz.csv', 'pointz.csv: No such file'}'
%!   out = made (row{1:2});
%!   assert (ischar (out) && ! isempty (strfind (out, row{3})), '%s', out);
%! end

%!test
%! [m, words] = made ("0,5;1.520,5\n0,6;1.400,5\n", 'points.csv');
%! assert ([m.value], [1520.5, 1400.5]);
%! assert (isempty (strfind (words, 'over')), words);
%! % the unit of the places stands in words
%! [~, words] = made ("time [ms];n [N]\n0,5;520\n0,6;400\n", 'points.csv');
%! assert (! isempty (strfind (words, 'n,,N,,,n over time in ms')), words);
%! % three columns of whole numbers may be what they seem
%! m = made ("1,520,5\n2,400,6\n", 'points.csv');
%! assert ({[m.value], [m.sd]}, {[520, 400], [5, 6]});

% SPDX-License-Identifier: GPL-3.0-only
