% PROCESSORSECONDS  Processor time of this Octave and of what it has started.
%
% CALL: SECONDS = processorSeconds ()
%
%   SECONDS  user and system time of this process and of its children that have
%            ended; where the system does not tell of these, its own
%
% See also: originLines

function seconds = processorSeconds ()
  file = '/proc/self/stat';
  if ~isfile (file)
    seconds = cputime ();
    return
  end
  % proc(5): utime, stime, cutime, cstime are fields 14 to 17; the second one, in
  % brackets, may hold blanks
  fields = strsplit (regexprep (fileread (file), '^.*\) ', ''), ' ');
  seconds = sum (str2double (fields(12:15))) / 100;
end

%!test
%! before = processorSeconds ();
%! system ('i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done');
%! assert (processorSeconds () > before);

% SPDX-License-Identifier: GPL-3.0-only
