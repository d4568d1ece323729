#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 60 adc_bailout 0 }
background{rgb 0.0}
camera{perspective location <2.0,1.5,-5.3> direction <-0.472073930306923,-0.3478439486472065,1.242299816597166> right <0.934783580588349,0.0,0.3552177606235726> up <-0.08994457796814108,0.9674114194242542,0.2366962578108976>}
box{<-1.1,-1.3,0.9>,<0.1,1.0,-0.7> pigment{rgb 1} finish{ambient 0 emission 0.9 diffuse 0.0 specular 0 phong 0 reflection{0.0} } rotate <-31.0,-17.0,53.0>}
box{<0.1,-1.3,0.9>,<1.3,0.6,-0.7> pigment{rgb 1} finish{ambient 0 emission 0.3 diffuse 0.0 specular 0 phong 0 reflection{0.0} } rotate <-31.0,-17.0,53.0>}
box{<-0.4,0.2,-0.1>,<0.1,1.0,-0.7> pigment{rgb 1} finish{ambient 0 emission 0.6 diffuse 0.0 specular 0 phong 0 reflection{0.0} } rotate <-31.0,-17.0,53.0>}
